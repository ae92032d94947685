package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;

/**
 * The current call, or the last one.
 *
 * @param number of the other party, empty if unknown
 * @param seconds since the call was connected, counted in speech
 * @param keyed the keys sent, newest last
 * @param heard the keys received, newest last
 * @param words the sentence of a robot after the newest key; empty if there is none
 * @param ended the cause of the release, until the next key or call
 * @param waiting number of a second caller, empty text if unknown
 * @param held number of the held party, empty text if unknown
 * @param onHold true if the other party holds this call
 * @param incoming true if the other party called; robots do not call
 */
public record CallSnapshot(
        CallPhase phase,
        String number,
        int seconds,
        String keyed,
        String heard,
        String words,
        Optional<Cause> ended,
        Optional<String> waiting,
        Optional<String> held,
        boolean onHold,
        boolean incoming) {
    /** The newest key from the far end. */
    public Optional<DtmfKey> tone() {
        return heard.isEmpty() ? Optional.empty() : Optional.of(DtmfKey.of(heard.charAt(heard.length() - 1)));
    }

    /**
     * The text key of a tone's meaning in a robot's replies; empty for other tones, and for a caller's: robots do not
     * call.
     */
    public Optional<String> meaningOf(DtmfKey key) {
        return incoming ? Optional.empty() : ToneMeaning.textKey(key);
    }
}
