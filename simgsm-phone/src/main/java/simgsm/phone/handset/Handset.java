package simgsm.phone.handset;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.HomeKeys;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.screen.ScreenNavigation;
import simgsm.phone.screen.UserSettings;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.sim.SimPhoneBook;
import simgsm.speech.AudioInput;
import simgsm.speech.AudioOutput;
import simgsm.station.StationCommands;
import simgsm.station.context.StationEvent;
import simgsm.tone.ToneExperiment;
import simgsm.tone.ToneSet;

/**
 * The phone without a window. Station, console and window call it on the station's owner thread; {@link #snapshot} may be
 * called from any thread.
 */
public final class Handset {
    private static final int KEY_MILLIS = 100;
    private static final int SAMPLES_PER_MILLI = 8;
    private final Msisdn own;
    private final Consumer<StationEvent> listener;
    private final HandsetAudio audio;
    private final PhoneCall call = new PhoneCall();
    private final HandsetStore store;
    private final CallHistory history;
    private final HandsetLog events;
    private final ScreenNavigation screens;
    private final UserCodes userCodes;
    private final HomeKeys home;
    private final KeySender keysInBand;
    private final SignalledKeySender keysSignalled;
    private final MessageSubmission submission;
    private final SettledAction settled = new SettledAction(this::isSettled);
    private final ServiceCodes codes = new ServiceCodes(this);
    private StationCommands station;
    private UserSettings settings;
    private volatile HandsetSnapshot snapshot;

    /**
     * Creates a handset without a station.
     *
     * @param tones supervisory tones, such as busy
     * @param phoneBook the SIM's
     * @param listener receives the station's events and {@link HandsetEvent}s, after the handset has changed
     * @param wallClock for the times of messages and calls
     */
    public Handset(
            Msisdn own,
            UserSettings settings,
            ToneSet tones,
            SimPhoneBook phoneBook,
            Consumer<StationEvent> listener,
            AudioOutput output,
            InstantSource wallClock) {
        this.own = own;
        this.settings = settings;
        this.listener = listener;
        Consumer<String> sent = run -> report(new HandsetEvent.KeysSent(run));
        keysInBand = new KeySender(sent);
        keysSignalled = new SignalledKeySender(() -> station, sent);
        Supplier<KeySender> keys = () -> this.settings.keyMode() == KeyMode.SIGNALLED ? keysSignalled : keysInBand;
        audio = new HandsetAudio(
                output, keys, tones, key -> report(call.toneHeard(key)), text -> report(call.wordsHeard(text)));
        audio.setSound(settings.ringTone(), settings.volume());
        store = new HandsetStore(phoneBook, wallClock);
        submission = new MessageSubmission(store.mailbox());
        history = new CallHistory(store.log(), wallClock);
        events = new HandsetLog(wallClock, store.contacts()::nameOf);
        phoneBook.whenChanged(this::changed);
        screens = new ScreenNavigation(
                store.mailbox(),
                store.log(),
                store.contacts(),
                () -> this.settings,
                () -> AboutPhone.lines(own, station, store.contacts()));
        home = new HomeKeys(screens);
        userCodes = new UserCodes(code -> station.sendUssd(code));
    }

    /** The texts stored for the next run: names, calls, messages, settings. */
    public Map<String, String> texts() {
        return store.texts(settings);
    }

    /** Restores the texts of an earlier run, after {@link #attach}. @return the keys of invalid texts */
    public List<String> restore(Map<String, String> texts) {
        List<String> wrong = new ArrayList<>(store.restore(texts));
        try {
            set(settings.restored(texts));
        } catch (IllegalArgumentException e) {
            wrong.add("setting");
        }
        changed();
        return wrong;
    }

    /** Passes the stored texts to the receiver now and after each change, before the change's event is reported. */
    public void keepBy(Consumer<Map<String, String>> receiver) {
        store.keepBy(receiver, settings);
    }

    /** Sets the station, once, before anything else. */
    public void attach(StationCommands newStation) {
        station = newStation;
        changed();
    }

    /** Sets the microphone of later frames; without it calls have the sound of keys and files only. */
    public void setMicrophone(AudioInput microphone) {
        audio.setMicrophone(microphone);
    }

    PhoneCall call() {
        return call;
    }

    HandsetAudio audio() {
        return audio;
    }

    ScreenNavigation screens() {
        return screens;
    }

    HomeKeys home() {
        return home;
    }

    public StationCommands station() {
        return station;
    }

    UserSettings settings() {
        return settings;
    }

    /** The current state; may be called from any thread. Null before {@link #attach}. */
    public HandsetSnapshot snapshot() {
        return snapshot;
    }

    // Commands of console and window. A refusal is the reason why a command has no effect.

    public Optional<Refusal> dial(Msisdn number) {
        return call.dial(station, number);
    }

    public Optional<Refusal> answer() {
        history.taken();
        return station.answer() ? Optional.empty() : Optional.of(Refusal.NOTHING_RINGS);
    }

    public Optional<Refusal> hangUp() {
        history.taken();
        audio.dropKeys();
        return station.hangUp() || station.endUssd() ? Optional.empty() : Optional.of(Refusal.NO_CALL);
    }

    /** Holds the active call and takes the waiting or held one; without an active call takes the held one. */
    public Optional<Refusal> hold() {
        return station.hold() ? Optional.empty() : Optional.of(Refusal.NOTHING_TO_HOLD);
    }

    /** Rejects the waiting call, or ends the held one. */
    public Optional<Refusal> rejectSecond() {
        return station.rejectWaiting() ? Optional.empty() : Optional.of(Refusal.NO_SECOND_CALL);
    }

    /** Tells the network of its user. */
    public UserCodes userCodes() {
        return userCodes;
    }

    /** Performs codes typed by the user. */
    public ServiceCodes codes() {
        return codes;
    }

    /** Queues keys of 100 ms; they wait until the call is connected. */
    public Optional<Refusal> press(List<DtmfKey> pressed) {
        return press(pressed, KEY_MILLIS, () -> {});
    }

    /**
     * As above, with tones of another length.
     *
     * @param toneMillis 70 at least
     * @param whenSent runs when the last tone has been sent; never if the call ends before
     */
    public Optional<Refusal> press(List<DtmfKey> pressed, int toneMillis, Runnable whenSent) {
        Optional<Refusal> refusal = call.refusalOfKeys();
        if (refusal.isEmpty()) {
            audio.press(pressed, toneMillis, whenSent);
            pressed.forEach(this::keyed);
        }
        changed();
        return refusal;
    }

    /** Notes a key sent to the far end. */
    void keyed(DtmfKey key) {
        call.keyed(key);
        events.keyed(key);
    }

    /** Sends a sound in the call instead of a microphone's. @param samples at 8 kHz */
    public Optional<Refusal> play(short[] samples) {
        Optional<Refusal> refusal = call.refusalOfKeys();
        if (refusal.isEmpty()) {
            audio.play(samples, () -> report(new HandsetEvent.SoundPlayed(samples.length / SAMPLES_PER_MILLI)));
        }
        return refusal;
    }

    public Optional<Refusal> sendMessage(Msisdn to, String text) {
        Optional<Refusal> refusal = submission.submit(station, to, text);
        changed();
        submission.release(this::accept);
        return refusal;
    }

    public void powerOn() {
        station.powerOn();
        screens.askForPin(station.snapshot().card());
        changed();
    }

    public void powerOff() {
        audio.dropKeys();
        station.powerOff();
        audio.stopTones();
        home.clear();
        screens.home();
        changed();
    }

    /** Marks the received messages as read. @return the messages before that, oldest first */
    public List<StoredMessage> readInbox() {
        List<StoredMessage> inbox = store.mailbox().in(MessageFolder.INBOX);
        store.mailbox().markAllRead(MessageFolder.INBOX);
        changed();
        return inbox;
    }

    /** Runs the action as soon as all keys are sent, all messages acknowledged and a USSD text answered. */
    public void whenSettled(Runnable action) {
        settled.set(action);
    }

    private boolean isSettled() {
        return audio.keysAreSent() && !store.mailbox().hasUnacknowledged() && !screens.awaitsUssd();
    }

    /** Publishes the arrival or loss of a sound device; called about once a second. */
    public void checkSoundDevice() {
        if (audio.earpiece().isAudible() != snapshot.audible()) {
            changed();
        }
    }

    /** Changes the user's settings. */
    public void set(UserSettings next) {
        settings = next;
        audio.setSound(next.ringTone(), next.volume());
        station.setCodec(next.codec());
        changed();
    }

    /** Sets the tone scope's experiment; the sound does not change. */
    public void tryOut(ToneExperiment experiment) {
        audio.earpiece().tryOut(experiment);
        changed();
    }

    /** True if {@link #timePassed} is due within 20 ms: key tones, letters, and long presses without a call. */
    public boolean wantsTime() {
        return audio.wantsTime() || screens.wantsTime() || home.wantsTime(call.phase());
    }

    /** Sets an action that runs whenever an event makes the handset want time. */
    public void whenTimeIsWanted(Runnable action) {
        audio.whenTimeIsWanted(action);
    }

    public void timePassed(long nowNanos) {
        boolean letterStands = screens.timePassed(nowNanos);
        boolean soundChanged = audio.timePassed(nowNanos);
        boolean longPress = home.timePassed(nowNanos, call.phase());
        if (longPress) {
            audio.keyUp();
        }
        if (letterStands || soundChanged || longPress) {
            changed();
        }
    }

    /** Fills the next 20 ms of speech for the far end. */
    public void fillFrame(short[] frame) {
        boolean soundChanged = audio.fillFrame(frame);
        if (call.framePassed() || soundChanged) {
            changed();
        }
        settled.check();
    }

    /** An event of the station. */
    public void accept(StationEvent event) {
        if (event instanceof StationEvent.SpeechReceived speech) {
            audio.hear(speech.samples());
        } else if (!submission.defers(event)) {
            follow(event);
            report(event);
            userCodes.accept(event);
            settled.check();
        }
    }

    private void follow(StationEvent event) {
        if (event instanceof StationEvent.OfCall ofCall) {
            history.accept(ofCall, call.snapshot().seconds());
            call.accept(ofCall);
            audio.accept(ofCall);
            home.accept(ofCall);
        } else if (event instanceof StationEvent.KeysRefused refused) {
            screens.note(Note.Kind.KEYS_REFUSED, String.valueOf(refused.cause().code()));
            report(new HandsetEvent.KeysNotSent(audio.dropKeys(), refused.cause()));
        } else if (event instanceof StationEvent.OfKey ofKey) {
            keysSignalled.accept(ofKey);
        } else if (event instanceof StationEvent.OfMessage message) {
            store.mailbox().accept(message);
        } else if (event instanceof StationEvent.NetworkTimeReceived received) {
            store.setClock(received.time());
        } else {
            screens.accept(event, station.snapshot().card());
        }
    }

    void report(StationEvent event) {
        events.accept(event);
        changed();
        listener.accept(event);
    }

    boolean isPowered() {
        return station.snapshot().powered();
    }

    HomeKeys.Situation situation() {
        return call.situation(
                store.mailbox().unread(MessageFolder.INBOX), store.log().unseenMissed());
    }

    void changed() {
        if (station == null) {
            return;
        }
        store.keepChanges(settings);
        snapshot = new HandsetSnapshot(
                own,
                station.snapshot(),
                call.snapshot(),
                home.typed(),
                home.caret(),
                screens.current(),
                screens.isHome() ? home.softKeys(situation()) : screens.softKeys(),
                store.mailbox().folders(),
                store.contacts().names(),
                store.log().unseenMissed(),
                settings,
                audio.sounding(),
                audio.earpiece().trace(),
                store.clock(),
                audio.earpiece().isAudible(),
                events.entries());
    }
}
