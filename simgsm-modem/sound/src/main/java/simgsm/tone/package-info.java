/**
 * Call-progress tones, the level of a tone, a Fourier transform, and the experiments of a tone scope: noise, shifted frequencies, a codec.
 * 8 kHz, 16-bit mono samples; time is counted in samples, without audio device or clock.
 *
 * <p>Read first: {@link simgsm.tone.ToneSet} for the tones of a country's network, {@link simgsm.tone.Disturber} for
 * the experiments.
 */
package simgsm.tone;
