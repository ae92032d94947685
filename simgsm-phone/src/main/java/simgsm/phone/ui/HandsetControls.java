package simgsm.phone.ui;

import java.util.function.ObjLongConsumer;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.HandsetKeys;
import simgsm.phone.screen.PhoneKey;
import simgsm.tone.ToneExperiment;

/** The window's access to the handset, owned by another thread. */
@FunctionalInterface
public interface HandsetControls {
    /** Runs an action on the owner thread, with the time in nanoseconds. */
    void perform(ObjLongConsumer<Handset> action);

    default void keyDown(PhoneKey key) {
        perform((handset, now) -> new HandsetKeys(handset).keyDown(key, now));
    }

    default void keyUp(PhoneKey key) {
        perform((handset, now) -> new HandsetKeys(handset).keyUp(key, now));
    }

    /** Presses the keyboard's Enter; its meaning depends on the screen. */
    default void enterDown() {
        perform((handset, now) -> new HandsetKeys(handset).enterDown(now));
    }

    default void enterUp() {
        perform((handset, now) -> new HandsetKeys(handset).enterUp(now));
    }

    /** Presses a character of the keyboard. */
    default void charDown(char character) {
        perform((handset, now) -> new HandsetKeys(handset).charDown(character, now));
    }

    default void charUp(char character) {
        perform((handset, now) -> new HandsetKeys(handset).charUp(character, now));
    }

    /** Presses the keyboard's erase key. */
    default void eraseDown() {
        perform((handset, now) -> new HandsetKeys(handset).eraseDown());
    }

    /** Sets the tone scope's experiment. */
    default void tryOut(ToneExperiment experiment) {
        perform((handset, now) -> handset.tryOut(experiment));
    }
}
