# SPDX-License-Identifier: MIT
"""The studio as a user meets it: opens the real window on a display of its own, types, drags, saves,
and looks again and again for what comes of it, since a machine may be slow.

Usage: studio_window_test.py ZEROSET PRESETS
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

PATIENCE = 60  # seconds until something that should happen counts as missing
WIDTH, HEIGHT = 1280, 800
PICTURE = (420, 40, 1030, 700)  # left, top, right, bottom: inside the picture, without its messages
EDITOR = (40, 30, 380, 150)
SLIDERS = (140, 310, 380, 345)
SLIDER_GRAB = (0x3F, 0x97, 0xA5)
SWITCH = (150, 359)  # the box to tick in the second line of the sliders
PROGRESS = (0x4F, 0xB6, 0xC4)
POINT = (0xB6, 0xBE, 0xCA)  # of the plot
STATE = (945, 289, 1190, 313)  # of the accuracy panel
NUMBERS = (945, 359, 970, 459)  # of the accuracy panel, with its marks
PLOT = (1010, 635, 1260, 764)
COPY, MEASURE = (1140, 546), (1024, 593)  # buttons

PARAMETERS = 'param a = 0.3 in [0, 1] "depth"\nparam big = off'
EQUATION = 'x^2 + y^2 + 4*a*z^2 = 1.5 + big/2'
FORMULA = PARAMETERS + '\n' + EQUATION


class Failure(Exception):
    pass


def wait_for(what, condition):
    """Answers the first true value of the condition."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.1)
    raise Failure(f'waited {PATIENCE} s for: {what}')


class Display:
    def __init__(self):
        reader, writer = os.pipe()
        self.process = subprocess.Popen(
            ['Xvfb', '-displayfd', str(writer), '-screen', '0', f'{WIDTH}x{HEIGHT}x24',
             '-nolisten', 'tcp', '-noreset'],
            pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise Failure('Xvfb does not start')
        self.name = ':' + number

    def close(self):
        self.process.terminate()
        self.process.wait()


class Screen:
    """One look at the display."""

    def __init__(self, environment):
        self.bytes = subprocess.run(
            ['import', '-window', 'root', '-depth', '8', 'rgb:-'], env=environment, check=True,
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
        if len(self.bytes) != WIDTH * HEIGHT * 3:
            raise Failure(f'a look at the display has {len(self.bytes)} bytes')

    def part(self, box):
        left, top, right, bottom = box
        rows = (self.bytes[3 * (y * WIDTH + left):3 * (y * WIDTH + right)]
                for y in range(top, bottom))
        return b''.join(rows)

    def colours(self, box):
        part = self.part(box)
        return set(zip(part[0::3], part[1::3], part[2::3]))

    def places_of(self, colour, box):
        left, top, right, bottom = box
        wanted = bytes(colour)
        for y in range(top, bottom):
            for x in range(left, right):
                at = 3 * (y * WIDTH + x)
                if self.bytes[at:at + 3] == wanted:
                    yield x, y


class Studio:
    def __init__(self, program, presets, home, display):
        self.home = home
        self.environment = dict(
            os.environ, DISPLAY=display, HOME=str(home), XDG_DATA_HOME=str(home / 'data'),
            XDG_STATE_HOME=str(home / 'state'), XDG_CACHE_HOME=str(home / 'cache'),
            ZEROSET_PRESETS=presets, LIBGL_ALWAYS_SOFTWARE='1')
        self.environment.pop('WAYLAND_DISPLAY', None)
        self.log = open(home / 'log.txt', 'w+')
        self.process = subprocess.Popen([program, 'studio'], env=self.environment,
                                        stdout=self.log, stderr=subprocess.STDOUT)

    def __enter__(self):
        try:
            self.window = wait_for('the window', self.find_window)
            self.run('windowfocus', '--sync', self.window)
        except Failure as failure:
            self.__exit__(Failure, failure, None)
            raise
        return self

    def __exit__(self, kind, failure, _):
        if failure is not None:
            last = pathlib.Path('studio_window_test.png').absolute()
            subprocess.run(['import', '-window', 'root', str(last)], env=self.environment)
            self.log.flush()
            print('the last look at the display:', last)
            print('what the studio said:', (self.home / 'log.txt').read_text())
        self.close()

    def find_window(self):
        if self.process.poll() is not None:
            raise Failure(f'the studio ended with status {self.process.returncode}')
        found = subprocess.run(['xdotool', 'search', '--onlyvisible', '--name', ' - Zeroset$'],
                               env=self.environment, stdout=subprocess.PIPE, text=True)
        return found.stdout.split('\n')[0]

    def run(self, *words):
        done = subprocess.run(['xdotool', *words], env=self.environment, stdout=subprocess.PIPE,
                              text=True, check=True)
        return done.stdout.strip()

    def keys(self, *keys):
        self.run('key', *keys)

    def type(self, text):
        self.run('type', '--delay', '8', text)

    def title(self):
        return self.run('getwindowname', self.window)

    def look(self):
        if self.process.poll() is not None:
            raise Failure(f'the studio ended with status {self.process.returncode}')
        return Screen(self.environment)

    def drag(self, start, offset, steps=12):
        self.run('mousemove', str(start[0]), str(start[1]), 'mousedown', '1')
        for i in range(1, steps + 1):
            self.run('mousemove', str(start[0] + offset[0] * i // steps),
                     str(start[1] + offset[1] * i // steps))
        self.run('mouseup', '1')

    def settled_picture(self):
        """The picture, once it does not change any more."""
        last = [self.look().part(PICTURE)]

        def same_again():
            time.sleep(0.6)  # longer than the studio waits before it draws in full
            now = self.look().part(PICTURE)
            same = now == last[0]
            last[0] = now
            return same

        wait_for('the picture to come to rest', same_again)
        return last[0]

    def changed_picture(self, before, what):
        wait_for('another picture ' + what, lambda: self.look().part(PICTURE) != before)
        return self.settled_picture()

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.log.close()


def expect(condition, text):
    if not condition:
        raise Failure(text)


def has_marked_line(screen):
    """A line of the editor is tinted red."""
    return any(r > 80 and r > g + 30 and r > b + 30 for r, g, b in screen.colours(EDITOR))


def check_typing(studio):
    wait_for('a first picture', lambda: len(studio.look().colours(PICTURE)) > 50)
    first = studio.settled_picture()
    studio.keys('ctrl+l')
    studio.keys('ctrl+a')
    studio.type(FORMULA)
    studio.changed_picture(first, 'after typing')
    expect('* - Zeroset' in studio.title(), f'no mark of unsaved work in "{studio.title()}"')
    autosave = studio.home / 'state' / 'zeroset' / 'autosave.json'
    wait_for('the automatic copy', lambda: autosave.exists() and EQUATION in autosave.read_text())
    return studio.settled_picture()  # of what was typed last


def check_broken_text(studio, good):
    time.sleep(1.5)  # ends the burst of typing, so that undo takes only what follows
    studio.type(' + sine(z)')
    wait_for('a marked line', lambda: has_marked_line(studio.look()))
    expect(studio.settled_picture() == good, 'the picture changed although the text is broken')
    studio.keys('ctrl+z')
    wait_for('the mark to go', lambda: not has_marked_line(studio.look()))
    expect(studio.settled_picture() == good, 'the picture is another one after undo')


def check_slider(studio, before):
    studio.run('mousemove', '700', '400')
    grab = wait_for('a slider', lambda: list(studio.look().places_of(SLIDER_GRAB, SLIDERS)))
    middle = grab[len(grab) // 2]
    studio.drag(middle, (70, 0))
    studio.run('mousemove', '700', '400')
    return studio.changed_picture(before, 'after moving the slider')


def check_switch(studio, before):
    def click():
        studio.run('mousemove', *map(str, SWITCH), 'click', '1', 'mousemove', '700', '400')

    click()
    switched = studio.changed_picture(before, 'after a click on the switch')
    studio.keys('ctrl+z')
    wait_for('one undo to take the click back', lambda: studio.settled_picture() == before)
    click()
    wait_for('the switch to do the same again', lambda: studio.settled_picture() == switched)
    return switched


def check_camera(studio, before):
    studio.drag((700, 400), (120, 60))
    studio.changed_picture(before, 'after turning the camera')
    studio.keys('ctrl+z')
    wait_for('one undo to take the whole turn back',
             lambda: studio.settled_picture() == before)


def check_saving(studio):
    studio.keys('ctrl+shift+s')
    time.sleep(0.5)  # the name's field takes the keyboard
    studio.type('tests/dented ball')
    studio.keys('Return')
    file = studio.home / 'data' / 'zeroset' / 'presets' / 'tests' / 'dented ball.json'
    wait_for(f'the file {file}', file.exists)
    preset = json.loads(file.read_text())
    formula = preset['formula']
    text = formula if isinstance(formula, str) else '\n'.join(formula)
    expect(text == FORMULA, f'the saved formula is {text!r}')
    value = preset.get('parameters', {}).get('a')
    expect(value is not None and 0.4 < value < 0.9, f'the saved parameter is {value}')
    expect(preset['parameters'].get('big') is True, f"the saved switch is {preset['parameters']}")
    wait_for('a title without the mark', lambda: '*' not in studio.title())


def check_screenshot(studio):
    studio.keys('F12')
    folder = studio.home / 'data' / 'zeroset' / 'screenshots'
    file = wait_for('a screenshot', lambda: next(iter(folder.glob('*.png')), None))
    facts = subprocess.run(['identify', '-format', '%w %h %k', str(file)], check=True,
                           stdout=subprocess.PIPE, text=True).stdout.split()
    width, height, colours = map(int, facts)
    expect((width, height) == (1920, 1080), f'the screenshot is {width} x {height}')
    expect(colours > 50, f'the screenshot has only {colours} colours')


def pasted_report(studio):
    """What the button Copy of the accuracy panel puts into the clipboard."""
    studio.run('mousemove', *map(str, COPY), 'click', '1')
    time.sleep(1.5)  # ends the burst of typing before, so that one undo takes the pasting back
    studio.keys('ctrl+l')
    studio.keys('ctrl+End', 'Return', 'ctrl+v')
    autosave = studio.home / 'state' / 'zeroset' / 'autosave.json'
    wait_for('the pasted report', lambda: autosave.exists() and 'fragile: ' in autosave.read_text())
    formula = json.loads(autosave.read_text())['formula']
    studio.keys('ctrl+z')
    wait_for('one undo to take the pasting back', lambda: '*' not in studio.title())
    return formula if isinstance(formula, str) else '\n'.join(formula)


def has_verdict(studio):
    """The panel shows the colours of the overlay beside its counts."""
    marks = {(230, 30, 30), (255, 200, 0)}
    return len(marks & {tuple(c) for c in studio.look().colours(NUMBERS)}) == len(marks)


def check_accuracy(studio):
    def looks_idle():
        screen = studio.look()
        certified = any(g > 140 and g > r + 40 and g > b + 40 for r, g, b in screen.colours(STATE))
        return certified and not any(screen.places_of(PROGRESS, STATE))

    studio.keys('F5')
    wait_for('a certified reference', looks_idle)
    wait_for('the present setting in the plot', lambda: has_verdict(studio))
    report = pasted_report(studio)
    counts = {word: int(number) for word, number in re.findall(r'^(\w+): (\d+)$', report, re.M)}
    size = re.search(r'(\d+) x (\d+), reference certified', report)
    expect(size is not None, f'no certified reference in {report!r}')
    pixels = int(size[1]) * int(size[2])
    excused = counts['undecided'] + counts['fragile']
    expect(pixels > 10000 and counts['compared'] + excused == pixels, f'{counts} of {pixels} pixels')
    expect(counts['missed'] + counts['phantom'] + counts['moved'] < 0.02 * pixels, f'wrong: {counts}')
    # The text has been another one meanwhile: the reference must have come back with it.
    wait_for('the counts after undo', lambda: has_verdict(studio))
    studio.run('mousemove', *map(str, MEASURE), 'click', '1', 'mousemove', '700', '400')
    wait_for('points in the plot', lambda: any(studio.look().places_of(POINT, PLOT)))
    wait_for('measuring to end', looks_idle)
    report = pasted_report(studio)
    for setting in ('auto, Lipschitz scale 0.25', 'auto, Lipschitz scale 2',
                    'sphere, Lipschitz scale 1'):
        expect(re.search(rf'^{setting}, .* wrong, \d+\.\d+ ms$', report, re.M),
               f'no "{setting}" in {report!r}')


def check_end(studio):
    studio.keys('ctrl+q')
    wait_for('the studio to end', lambda: studio.process.poll() is not None)
    expect(studio.process.returncode == 0, f'status {studio.process.returncode} at the end')
    left = studio.home / 'state' / 'zeroset' / 'autosave.json'
    expect(not left.exists(), 'an automatic copy is left after an orderly end')


def check_recovery(open_studio, home):
    """After a crash, unsaved work is there again."""
    with open_studio() as studio:
        wait_for('a first picture', lambda: len(studio.look().colours(PICTURE)) > 50)
        studio.keys('ctrl+l')
        studio.keys('ctrl+a')
        studio.type('x^2 + y^2 = 0.77')
        autosave = home / 'state' / 'zeroset' / 'autosave.json'
        wait_for('the automatic copy', lambda: autosave.exists() and '0.77' in autosave.read_text())
        # Leaving the block kills it.
    with open_studio() as studio:
        wait_for('a first picture', lambda: len(studio.look().colours(PICTURE)) > 50)
        studio.keys('Return')
        wait_for('the recovered work', lambda: '* - Zeroset' in studio.title())
        studio.keys('ctrl+shift+s')
        time.sleep(0.5)
        studio.type('recovered')
        studio.keys('Return')
        file = home / 'data' / 'zeroset' / 'presets' / 'recovered.json'
        wait_for(f'the file {file}', file.exists)
        expect('0.77' in file.read_text(), 'the recovered work is not what was lost')


def check_without_display(program, home):
    environment = {key: value for key, value in os.environ.items()
                   if key not in ('DISPLAY', 'WAYLAND_DISPLAY')}
    done = subprocess.run([program, 'studio'], env=dict(environment, HOME=str(home)), text=True,
                          stderr=subprocess.PIPE, timeout=PATIENCE)
    expect(done.returncode == 1, f'status {done.returncode} without a display')
    expect('zeroset render' in done.stderr, f'without a display it says only: {done.stderr}')


def check_all(open_studio, home):
    with open_studio() as studio:
        typed = check_typing(studio)
        check_broken_text(studio, typed)
        moved = check_slider(studio, typed)
        switched = check_switch(studio, moved)
        check_camera(studio, switched)
        check_saving(studio)
        check_screenshot(studio)
        check_accuracy(studio)
        check_end(studio)
    check_recovery(open_studio, home)


def main():
    program, presets = sys.argv[1:3]
    display = Display()
    try:
        with tempfile.TemporaryDirectory() as folder:
            home = pathlib.Path(folder)
            check_without_display(program, home)
            check_all(lambda: Studio(program, presets, home, display.name), home)
    except Failure as failure:
        print('FAILED:', failure)
        return 1
    finally:
        display.close()
    print('ok')
    return 0


if __name__ == '__main__':
    sys.exit(main())
