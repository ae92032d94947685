"""Words of people: enrol and hear of simgsm-modem.jar beside pocketsphinx, on the Free Spoken Digit Dataset
(https://github.com/Jakobovski/free-spoken-digit-dataset, CC BY-SA 4.0: six people, 50 takes of each digit).

fsdd.py RECORDINGS [QUERIES]: a speaker's takes 0 to 3 of each digit are enrolled, takes 10 to 9 + QUERIES (default 5) are
heard; level within 6 dB, white noise by SNR over the active speech, A-law or GSM 06.10. Needs sox and pocketsphinx.
Prints a line a channel: right without refusal; right, wrong and refused at 0.92; pocketsphinx, which enrols nobody.
"""
import array
import math
import os
import random
import subprocess
import sys
import tempfile
import wave

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../..")
JAR = ["java", "-jar", os.path.join(ROOT, "target/dist/simgsm-modem.jar")]
PEOPLE = ["george", "jackson", "lucas", "nicolas", "theo", "yweweler"]
NAMES = "zero one two three four five six seven eight nine".split()
CHANNELS = [("a-law", 30), ("a-law", 15), ("gsm", 30), ("gsm", 15)]
MARGIN = 1920


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def over_telephone(source, target, codec, snr, rng):
    with wave.open(source) as take:
        samples = array.array("h", take.readframes(take.getnframes()))
    powers = [sum(s * s for s in samples[i:i + 160]) / 160 for i in range(0, len(samples) - 159, 160)]
    active = [p for p in powers if p > max(powers) / 1000]
    power = sum(active) / len(active)
    gain = 1600 * 10 ** (rng.uniform(-6, 6) / 20) / math.sqrt(power)
    noise = gain * math.sqrt(power) * 10 ** (-snr / 20)
    padded = [0] * MARGIN + list(samples) + [0] * MARGIN
    noisy = array.array("h", (max(-32768, min(32767, round(gain * s + rng.gauss(0, noise)))) for s in padded))
    with wave.open(target + ".clean", "wb") as wav:
        wav.setparams((1, 2, 8000, 0, "NONE", ""))
        wav.writeframes(noisy.tobytes())
    coded = target + (".gsm" if codec == "gsm" else ".al")
    run("sox", "-D", "-t", "wav", target + ".clean", "-r", "8000", "-c", "1", coded)
    run("sox", *([] if codec == "gsm" else ["-r", "8000", "-c", "1"]), coded, "-e", "signed", "-b", "16", target)


def main(recordings, queries):
    for codec, snr in CHANNELS:
        rng = random.Random(1)
        total = right = sure = wrong = sphinx = 0
        with tempfile.TemporaryDirectory() as folder:
            for person in PEOPLE:
                def take(digit, number):
                    target = os.path.join(folder, f"{digit}_{person}_{number}.wav")
                    source = os.path.join(recordings, f"{digit}_{person}_{number}.wav")
                    over_telephone(source, target, codec, snr, rng)
                    return target

                voice = os.path.join(folder, person)
                for digit, name in enumerate(NAMES):
                    run(*JAR, "enrol", "--templates", voice, name, *[take(digit, k) for k in range(4)])
                asked = [take(digit, 10 + k) for digit in range(10) for k in range(queries)]
                heard = run(*JAR, "hear", "--templates", voice, "--limit", "1", *asked)
                read = run(sys.executable, os.path.join(ROOT, "src/test/peers/pocketsphinx_words.py"), "digits", *asked)
                for line in heard.splitlines():
                    path, word, ratio = line.split("\t")
                    isright = NAMES[int(os.path.basename(path)[0])] == word
                    right += isright
                    sure += isright and float(ratio) <= 0.92
                    wrong += not isright and float(ratio) <= 0.92
                for line in read.splitlines():
                    path, word = line.split("\t")
                    sphinx += NAMES[int(os.path.basename(path)[0])] == word
                total += len(asked)
        print(f"{codec} {snr} dB, {total}: right {right / total:.1%}; at 0.92 right {sure / total:.1%},"
              f" wrong {wrong / total:.2%}, refused {1 - (sure + wrong) / total:.1%}; pocketsphinx {sphinx / total:.1%}",
              flush=True)


main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5)
