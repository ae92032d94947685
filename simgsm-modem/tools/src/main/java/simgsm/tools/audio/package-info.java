/**
 * Audio files as speech at 8 kHz. Read {@link simgsm.tools.audio.SpeechFile}.
 */
package simgsm.tools.audio;
