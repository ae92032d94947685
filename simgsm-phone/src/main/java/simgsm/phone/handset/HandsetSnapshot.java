package simgsm.phone.handset;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.SoftKeys;
import simgsm.phone.screen.UserSettings;
import simgsm.phone.store.Contacts;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.scope.ToneTrace;
import simgsm.station.StationSnapshot;

/**
 * The state of the handset for its views, immutable.
 *
 * @param own the phone's own number
 * @param typed the number being typed
 * @param caret the number of its digits before the cursor
 * @param softKeys functions of the two keys under the display
 * @param folders messages, oldest first
 * @param names by number, without a plus sign
 * @param missed calls not yet seen by the user
 * @param sounding the key with the tone that sounds now
 * @param clock set by the network
 * @param audible true with a sound device
 * @param log recent events, oldest first
 */
public record HandsetSnapshot(
        Msisdn own,
        StationSnapshot station,
        CallSnapshot call,
        String typed,
        int caret,
        Screen screen,
        SoftKeys softKeys,
        Map<MessageFolder, List<StoredMessage>> folders,
        Map<String, String> names,
        int missed,
        UserSettings settings,
        Optional<DtmfKey> sounding,
        ToneTrace trace,
        ClockSetting clock,
        boolean audible,
        List<HandsetLog.Entry> log) {

    public List<StoredMessage> in(MessageFolder folder) {
        return folders.get(folder);
    }

    /** The name of a number in the SIM's phone book; the number itself if it has none. */
    public String nameOf(String number) {
        return names.getOrDefault(Contacts.bare(number), number);
    }

    public int unread() {
        return unread(MessageFolder.INBOX);
    }

    public int unread(MessageFolder folder) {
        return (int) in(folder).stream().filter(message -> !message.read()).count();
    }
}
