/** DTMF tones, their receiver, speech codecs and recordings. Needs no sound device. */
module simgsm.sound {
    exports simgsm.dtmf;
    exports simgsm.scope;
    exports simgsm.speech;
    exports simgsm.tone;
    exports simgsm.words;
}
