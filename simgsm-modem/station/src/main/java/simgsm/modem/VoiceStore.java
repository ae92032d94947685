package simgsm.modem;

import simgsm.words.SpeakerTemplates;
import simgsm.words.SpokenWord;

/** The enrolled words of all callers, by their numbers. */
public interface VoiceStore {
    /** Returns no templates for a new caller, or if they cannot be read. */
    SpeakerTemplates read(String caller);

    /** Keeps a caller's template of a word, if it can be written. @param number from 1 */
    void add(String caller, String word, int number, SpokenWord template);
}
