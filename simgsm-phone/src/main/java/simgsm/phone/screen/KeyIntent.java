package simgsm.phone.screen;

import java.util.Optional;
import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.store.StoredMessage;
import simgsm.sim.PinLock;

/** The handset's action after a pressed key, beyond a change of the screen. */
public sealed interface KeyIntent {
    /** An intent without a parameter. */
    enum Simple implements KeyIntent {
        NOTHING,
        ANSWER,
        HANG_UP,
        /** Ends the ringing sound; the call remains unanswered. */
        SILENCE,
        /** Holds the active call, or takes the held or waiting one. */
        HOLD,
        /** Rejects the waiting call, or ends the held one. */
        REJECT_SECOND,
        END_USSD,
        LOUDER,
        QUIETER,
        SWITCH_OFF
    }

    /** Changes the screen, without a further action. */
    static KeyIntent after(Runnable change) {
        change.run();
        return Simple.NOTHING;
    }

    /** Plays the tone to the far end during a call, otherwise only locally. */
    record PlayTone(DtmfKey tone) implements KeyIntent {}

    /** @param text as typed, perhaps no number */
    record DialText(String text) implements KeyIntent {}

    /** A service code, or the reply to the network's question. */
    record SendUssd(String text) implements KeyIntent {}

    /** Gives the SIM a code of its user. */
    record UseCard(Function<PinLock, PinLock.Result> command) implements KeyIntent {}

    /** @param replaced failed message that is sent again */
    record SendText(Msisdn to, String text, Optional<StoredMessage> replaced) implements KeyIntent {}

    record ChangeSettings(UserSettings settings) implements KeyIntent {}
}
