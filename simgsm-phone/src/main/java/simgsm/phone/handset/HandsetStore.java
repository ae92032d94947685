package simgsm.phone.handset;

import java.time.InstantSource;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import simgsm.phone.screen.UserSettings;
import simgsm.phone.store.CallLog;
import simgsm.phone.store.Contacts;
import simgsm.phone.store.Mailbox;
import simgsm.phone.store.PhoneImage;
import simgsm.sim.SimPhoneBook;

/** The data stored for a handset's next run: names, calls, messages, settings. The clock's setting is not stored. */
final class HandsetStore {
    private final InstantSource wallClock;
    private final Mailbox mailbox;
    private final CallLog log = new CallLog();
    private final Contacts contacts;
    private final PhoneImage image;
    private Consumer<Map<String, String>> keep = texts -> {};
    private UserSettings kept;
    private ClockSetting clock = ClockSetting.NONE;

    HandsetStore(SimPhoneBook phoneBook, InstantSource wallClock) {
        this.wallClock = wallClock;
        mailbox = new Mailbox(wallClock);
        contacts = new Contacts(phoneBook);
        image = new PhoneImage(phoneBook, log, mailbox);
    }

    Mailbox mailbox() {
        return mailbox;
    }

    CallLog log() {
        return log;
    }

    Contacts contacts() {
        return contacts;
    }

    ClockSetting clock() {
        return clock;
    }

    void setClock(OffsetDateTime time) {
        clock = ClockSetting.of(time, wallClock.instant());
    }

    /** All data, as texts by key. */
    Map<String, String> texts(UserSettings settings) {
        Map<String, String> texts = image.texts();
        texts.putAll(settings.texts());
        return texts;
    }

    /** Restores names, calls and messages. @return the keys of invalid texts */
    List<String> restore(Map<String, String> texts) {
        return image.restore(texts);
    }

    /** Passes all data to this receiver, now and whenever {@link #keepChanges} finds a change. */
    void keepBy(Consumer<Map<String, String>> receiver, UserSettings settings) {
        keep = receiver;
        keep.accept(texts(settings));
    }

    void keepChanges(UserSettings settings) {
        boolean isChanged = image.hasChanged() | !settings.equals(kept);
        kept = settings;
        if (isChanged) {
            keep.accept(texts(settings));
        }
    }
}
