package simgsm.words;

/**
 * 25 ms of speech for recognition.
 *
 * @param bands magnitudes of the {@value MelSpectrum#BANDS} bands
 * @param energyDb power of the samples, in dB
 */
public record SpeechFrame(float[] bands, double energyDb) {}
