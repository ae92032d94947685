package simgsm.phone.handset;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneExperiment;
import simgsm.dtmf.ToneSet;
import simgsm.phone.handset.Screen.Note;
import simgsm.sms.ChannelList;
import simgsm.speech.AudioOutput;
import simgsm.station.SpeechSource;
import simgsm.station.StationListener;

/**
 * The phone. The station tells it what happens and asks it for speech; console and window ask it to act; all of that on
 * the station's owner thread. {@link #snapshot} may be asked by any thread.
 */
public final class Handset {
    private final Msisdn own;
    private final HandsetListener listener;
    private final Sounds sounds;
    private final PhoneCall call;
    private final HandsetDeeds deeds = new HandsetDeeds(this);
    private final Mailbox mailbox = new Mailbox();
    private final Screens screens = new Screens(mailbox, deeds);
    private final HomeKeys home = new HomeKeys(screens, deeds);
    private final MessageDesk messages;
    private final KeyMode keyMode;
    private final KeySender line;
    private final SignalledKeys signalledKeys;
    private StationSide station;
    private Runnable whenSettled;
    private volatile HandsetSnapshot newest;

    /**
     * A handset that waits for its station.
     *
     * @param keyMode how keys are sent in a call
     * @param wallClock for the time that messages came
     */
    public Handset(Msisdn own, KeyMode keyMode, HandsetListener listener, AudioOutput output, InstantSource wallClock) {
        this(own, keyMode, ToneSet.EUROPEAN, listener, output, wallClock);
    }

    /** @param tones how this phone lets busy and the like sound */
    public Handset(
            Msisdn own,
            KeyMode keyMode,
            ToneSet tones,
            HandsetListener listener,
            AudioOutput output,
            InstantSource wallClock) {
        this.own = own;
        this.keyMode = keyMode;
        this.listener = listener;
        this.line = new KeySender(listener::sent);
        this.signalledKeys = new SignalledKeys(() -> station, line::toneLeft);
        if (keyMode == KeyMode.SIGNALLED) {
            line.goBy(signalledKeys);
        }
        this.sounds = new Sounds(output, line, tones, this::toneHeard);
        this.call = new PhoneCall(sounds);
        this.messages = new MessageDesk(mailbox, screens, () -> station, wallClock, this::changed);
    }

    /** Gives the handset its station, once, before anything else. */
    public void attach(StationSide newStation) {
        station = newStation;
        changed();
    }

    /** What the station tells the handset. */
    public StationListener ears() {
        return new StationEars(this, listener);
    }

    /** What the station's news of signalled keys are for. */
    SignalledKeys signalledKeys() {
        return signalledKeys;
    }

    /** What the handset says in a call. */
    public SpeechSource mouth() {
        return this::say;
    }

    /** The newest state; any thread may ask. Null before {@link #attach}. */
    public HandsetSnapshot snapshot() {
        return newest;
    }

    // What console and window ask for. A refusal says why nothing happens.

    public Optional<Refusal> dial(Msisdn number) {
        if (!isPowered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        if (call.phase() != CallPhase.NONE || !station.dial(number)) {
            return Optional.of(Refusal.CALL_UNDER_WAY);
        }
        return Optional.empty();
    }

    public Optional<Refusal> answer() {
        return station.answer() ? Optional.empty() : Optional.of(Refusal.NOTHING_RINGS);
    }

    public Optional<Refusal> hangUp() {
        sounds.dropKeys();
        return station.hangUp() ? Optional.empty() : Optional.of(Refusal.NO_CALL);
    }

    /** Queues keys of 100 ms; before the call is connected they wait for it. */
    public Optional<Refusal> press(List<DtmfKey> keys) {
        Optional<Refusal> refusal = call.press(keys);
        changed();
        return refusal;
    }

    public Optional<Refusal> sendMessage(Msisdn to, String text) {
        return messages.send(to, text);
    }

    public void powerOn() {
        station.powerOn();
        changed();
    }

    public void powerOff() {
        sounds.dropKeys();
        station.powerOff();
        sounds.quiet();
        home.clear();
        changed();
    }

    /** Whether there is room for messages; without it the network keeps them. */
    public void memory(boolean isAvailable) {
        station.memory(isAvailable);
    }

    /** Broadcasts on other channels are discarded. */
    public void wantBroadcasts(ChannelList channels) {
        station.wantBroadcasts(channels);
    }

    /** The messages that have come, oldest first, as they are before this call marks them as read. */
    public List<StoredMessage> readInbox() {
        return messages.readInbox();
    }

    /** Runs the act once no key waits to leave and the network has acknowledged every message; perhaps at once. */
    public void whenSettled(Runnable act) {
        whenSettled = act;
        checkSettled();
    }

    void checkSettled() {
        if (whenSettled != null && sounds.keysHaveLeft() && !mailbox.hasUnacknowledged()) {
            Runnable act = whenSettled;
            whenSettled = null;
            act.run();
        }
    }

    /** A sound device may come or go at any time; asked now and then, so that the view tells. */
    public void lookAtSound() {
        if (sounds.isAudible() != newest.audible()) {
            changed();
        }
    }

    // Keys of the window.

    /** A key goes down; it sounds until {@link #keyUp}. */
    public void keyDown(PhoneKey key, long nowNanos) {
        timePassed(nowNanos);
        home.hold(key, nowNanos);
        if (!isPowered()) {
            if (key == PhoneKey.END) {
                powerOn();
            }
            return;
        }
        if (key == PhoneKey.END && call.phase() != CallPhase.NONE) {
            screens.home();
            hangUp();
        } else if (key == PhoneKey.CALL && call.phase() == CallPhase.RINGING) {
            answer();
        } else if (screens.isHome()) {
            pressAtHome(key);
        } else {
            screens.press(key, nowNanos);
        }
        changed();
    }

    private void pressAtHome(PhoneKey key) {
        if (call.phase() == CallPhase.NONE) {
            call.forgetEnd();
            if (sounds.hearsNetwork()) {
                station.hangUp();
            }
        }
        home.press(key, call.phase());
    }

    /** The key goes up again. */
    public void keyUp(PhoneKey key, long nowNanos) {
        timePassed(nowNanos);
        sounds.up();
        home.letGo(key);
        changed();
    }

    /** A keyboard's Enter: it calls where the green key alone makes sense, and is OK wherever something is to choose. */
    public void enterDown(long nowNanos) {
        boolean calls = screens.isHome() || call.phase() == CallPhase.RINGING;
        keyDown(calls ? PhoneKey.CALL : PhoneKey.OK, nowNanos);
    }

    public void enterUp(long nowNanos) {
        keyUp(PhoneKey.OK, nowNanos);
    }

    /** A character of a keyboard goes down: a letter while writing, else the key of that name. */
    public void charDown(char character, long nowNanos) {
        if (!isPowered()) {
            return;
        }
        if (screens.type(character)) {
            changed();
        } else if (character == '+' && screens.isHome() && call.phase() == CallPhase.NONE) {
            home.plus();
            changed();
        } else {
            PhoneKey.ofSymbol(character).ifPresent(key -> keyDown(key, nowNanos));
        }
    }

    /** That character goes up. */
    public void charUp(char character, long nowNanos) {
        PhoneKey.ofSymbol(character).ifPresent(key -> keyUp(key, nowNanos));
    }

    /** Dials what was typed; a note says if it cannot be. */
    void dialText(String number) {
        if (!Screens.isNumber(number)) {
            screens.note(Note.Kind.NOT_A_NUMBER, number);
        } else if (dial(Msisdn.parse(number)).isPresent()) {
            screens.note(Note.Kind.REFUSED, number);
        }
    }

    /** Sends what was written; a note says if it cannot be. @return whether it was handed in */
    boolean sendText(Msisdn to, String text) {
        boolean refused = sendMessage(to, text).isPresent();
        if (refused) {
            screens.note(Note.Kind.REFUSED, to.digits());
        }
        return !refused;
    }

    /** What the scope makes of the sound that it hears; nobody else hears any of it. */
    public void tryOut(ToneExperiment experiment) {
        sounds.tryOut(experiment);
        changed();
    }

    void keySounds(DtmfKey tone) {
        call.down(tone);
    }

    void keyIsSilent() {
        sounds.up();
    }

    // Time, for what happens without a call: key tones, letters, long presses.

    /** Whether {@link #timePassed} is to be called within the next 20 ms; may become true by acts and by the station. */
    public boolean wantsTime() {
        return sounds.wantsTime() || screens.wantsTime() || home.wantsTime(call.phase());
    }

    /** Has the act run whenever the station's news make the handset want time. */
    public void whenTimeIsWanted(Runnable act) {
        sounds.whenTimeIsWanted(act);
    }

    public void timePassed(long nowNanos) {
        boolean letterStands = screens.timePassed(nowNanos);
        boolean soundChanged = sounds.timePassed(nowNanos);
        boolean longPress = home.timePassed(nowNanos, call.phase());
        if (letterStands || soundChanged || longPress) {
            changed();
        }
    }

    // What the station brings.

    private void say(short[] frame) {
        if (call.say(frame)) {
            changed();
        }
        checkSettled();
    }

    void hear(short[] frame) {
        sounds.hear(frame);
    }

    void networkTones(boolean heard) {
        sounds.networkTones(heard);
        changed();
    }

    private void toneHeard(DtmfKey key) {
        call.toneHeard(key);
        changed();
        listener.toneHeard(key);
    }

    void callBegan(CallPhase phase, String number) {
        home.clear();
        if (!number.isEmpty()) {
            home.remember(number);
        }
        screens.home();
        call.began(phase, number);
        changed();
    }

    void callWaits(String number) {
        call.waits(number);
        changed();
    }

    void waitingCallIsOver() {
        call.waitsNoMore();
        changed();
    }

    void callAlerts() {
        call.alerts();
        changed();
    }

    void callConnected(Optional<String> number) {
        call.connected(number);
        changed();
    }

    void callEnded(Cause cause) {
        call.ended(cause);
        changed();
    }

    /** The network takes no keys. @return those that have not left */
    String keysRefused(Cause cause) {
        screens.note(Note.Kind.KEYS_REFUSED, String.valueOf(cause.code()));
        String rest = line.drop();
        changed();
        return rest;
    }

    /** What the station's news of messages are for. */
    MessageDesk messages() {
        return messages;
    }

    private boolean isPowered() {
        return station.snapshot().powered();
    }

    /** Publishes what is now. */
    void changed() {
        newest = new HandsetSnapshot(
                own,
                station.snapshot(),
                call.snapshot(),
                home.typed(),
                screens.current(),
                mailbox.in(MessageFolder.INBOX),
                mailbox.in(MessageFolder.OUTBOX),
                mailbox.in(MessageFolder.BROADCASTS),
                keyMode,
                sounds.sounding(),
                sounds.trace(),
                sounds.isAudible());
    }
}
