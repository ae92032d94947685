package simgsm.phone.handset;

import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneTrace;
import simgsm.station.StationSnapshot;

/**
 * The state of the handset for its views, immutable.
 *
 * @param own the phone's own number
 * @param typed the number being typed
 * @param inbox oldest first, as the other folders
 * @param keyMode how keys are sent in a call
 * @param sounding the key whose tone sounds now
 * @param audible whether there is a sound device
 */
public record HandsetSnapshot(
        Msisdn own,
        StationSnapshot station,
        CallSnapshot call,
        String typed,
        Screen screen,
        List<StoredMessage> inbox,
        List<StoredMessage> outbox,
        List<StoredMessage> broadcasts,
        KeyMode keyMode,
        Optional<DtmfKey> sounding,
        ToneTrace trace,
        boolean audible) {

    public List<StoredMessage> in(MessageFolder folder) {
        return switch (folder) {
            case INBOX -> inbox;
            case OUTBOX -> outbox;
            case BROADCASTS -> broadcasts;
        };
    }

    public int unread() {
        return unread(MessageFolder.INBOX);
    }

    public int unread(MessageFolder folder) {
        return (int) in(folder).stream().filter(message -> !message.read()).count();
    }
}
