/**
 * Speech between terminals: 20 ms frames of 8 kHz, 16-bit mono samples, the codecs that carry them, WAV files, and the
 * sound card behind a port; and who listens in on calls, to record them or to let them be heard.
 *
 * <p>Read first: {@link simgsm.speech.SpeechCodec}, then {@link simgsm.speech.AudioOutput}.
 */
package simgsm.speech;
