"""Reads WAV files (8 kHz) by pocketsphinx with its own en-us model; prints path, tab, words. Needs sox.

pocketsphinx_words.py digits|numbers FILE.wav...
"""
import subprocess
import sys

from pocketsphinx import Config, Decoder

DIGITS = "zero | one | two | three | four | five | six | seven | eight | nine"
TEENS = "ten | eleven | twelve | thirteen | fourteen | fifteen | sixteen | seventeen | eighteen | nineteen"
TENS = "twenty | thirty | forty | fifty | sixty | seventy | eighty | ninety"
GRAMMARS = {
    "digits": f"public <d> = {DIGITS};",
    "numbers": f"<d> = {DIGITS}; <b> = <d> | {TEENS} | ({TENS}) [<d>];"
    " public <n> = [<d> thousand] [<d> hundred] [<b>];",
}


def main(grammar, files):
    decoder = Decoder(Config(lm=None, samprate=16000, loglevel="FATAL"))
    decoder.add_jsgf_string("g", "#JSGF V1.0; grammar g; " + GRAMMARS[grammar])
    decoder.activate_search("g")
    for name in files:
        raw = subprocess.run(
            ["sox", name, "-t", "raw", "-r", "16000", "-e", "signed", "-b", "16", "-c", "1", "-"],
            check=True, capture_output=True).stdout
        decoder.start_utt()
        decoder.process_raw(raw, full_utt=True)
        decoder.end_utt()
        print(name, decoder.hyp().hypstr if decoder.hyp() else "", sep="\t")


main(sys.argv[1], sys.argv[2:])
