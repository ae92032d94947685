/**
 * The system's sound device as a {@link simgsm.speech.AudioOutput}.
 */
package simgsm.audio;
