/**
 * Speech: 20 ms frames of 8 kHz, 16-bit mono samples, their codecs, WAV files, audio output, and the recording and
 * playing of calls.
 *
 * <p>Read first: {@link simgsm.speech.SpeechCodec}, then {@link simgsm.speech.AudioOutput}.
 */
package simgsm.speech;
