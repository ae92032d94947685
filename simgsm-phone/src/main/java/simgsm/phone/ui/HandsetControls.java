package simgsm.phone.ui;

import simgsm.dtmf.ToneExperiment;
import simgsm.phone.handset.PhoneKey;

/** Where the window's acts go: into the handset, on its own thread. */
public interface HandsetControls {
    void keyDown(PhoneKey key);

    void keyUp(PhoneKey key);

    /** The keyboard's Enter goes down; what it does depends on what is shown. */
    void enterDown();

    void enterUp();

    /** A character of the keyboard goes down. */
    void charDown(char character);

    void charUp(char character);

    /** The scope is to hear the sound so; nothing else does. */
    void tryOut(ToneExperiment experiment);
}
