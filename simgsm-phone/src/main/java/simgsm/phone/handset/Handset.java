package simgsm.phone.handset;

import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
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
    private static final int FRAMES_PER_SECOND = 50;

    private final Msisdn own;
    private final HandsetListener listener;
    private final InstantSource wallClock;
    private final Sounds sounds;
    private final HandsetDeeds deeds = new HandsetDeeds(this);
    private final Mailbox mailbox = new Mailbox();
    private final Screens screens = new Screens(mailbox, deeds);
    private final HomeKeys home = new HomeKeys(screens, deeds);
    /** References of messages that failed while they were being handed in. */
    private final Map<Integer, RpCause> failedEarly = new HashMap<>();

    private final KeyMode keyMode;
    private final KeySender line;
    private final SignalledKeys signalledKeys;
    private StationSide station;
    private CallSnapshot call = CallSnapshot.NONE;
    private long callFrames;
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
        this.wallClock = wallClock;
        this.line = new KeySender(listener::sent);
        this.signalledKeys = new SignalledKeys(() -> station, line::toneLeft);
        if (keyMode == KeyMode.SIGNALLED) {
            line.goBy(signalledKeys);
        }
        this.sounds = new Sounds(output, line, tones, this::toneHeard);
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
        if (call.phase() == CallPhase.NONE) {
            return Optional.of(Refusal.NO_CALL);
        }
        if (call.phase() == CallPhase.RINGING) {
            return Optional.of(Refusal.NOT_ANSWERED);
        }
        sounds.press(keys);
        for (DtmfKey key : keys) {
            call = call.withKeyed(key.symbol());
        }
        changed();
        return Optional.empty();
    }

    public Optional<Refusal> sendMessage(Msisdn to, String text) {
        if (text.isEmpty()) {
            return Optional.of(Refusal.EMPTY_TEXT);
        }
        if (!isPowered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        int id;
        try {
            id = station.sendMessage(to, text);
        } catch (IllegalArgumentException tooLong) {
            return Optional.of(Refusal.TEXT_TOO_LONG);
        }
        mailbox.handedIn(id, to.digits(), text, wallClock.instant());
        RpCause early = failedEarly.remove(id);
        if (early != null) {
            mailbox.failed(id, early);
        }
        screens.added(Box.OUTBOX);
        changed();
        return Optional.empty();
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
        List<StoredMessage> inbox = mailbox.in(Box.INBOX);
        mailbox.markAllRead(Box.INBOX);
        changed();
        return inbox;
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
            call = call.withoutEnd();
            sounds.quiet();
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
        sounds.down(tone);
        if (call.phase() == CallPhase.CONNECTED) {
            call = call.withKeyed(tone.symbol());
        }
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
        boolean soundChanged = sounds.say(frame);
        if (call.phase() == CallPhase.CONNECTED) {
            callFrames++;
        }
        if (soundChanged || callFrames % FRAMES_PER_SECOND == 0) {
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
        call = call.withHeard(key.symbol());
        changed();
        listener.toneHeard(key);
    }

    void callBegan(CallPhase phase, String number) {
        call = CallSnapshot.begun(phase, number);
        callFrames = 0;
        home.clear();
        if (!number.isEmpty()) {
            home.remember(number);
        }
        screens.home();
        sounds.callBegan();
        if (phase == CallPhase.RINGING) {
            sounds.ringing();
        }
        changed();
    }

    void callWaits(String number) {
        call = call.withWaiting(Optional.of(number));
        sounds.callWaits();
        changed();
    }

    void waitingCallIsOver() {
        call = call.withWaiting(Optional.empty());
        sounds.quiet();
        changed();
    }

    void callAlerts() {
        call = call.in(CallPhase.ALERTING, call.number());
        sounds.ringBack();
        changed();
    }

    void callConnected(Optional<String> number) {
        call = call.in(CallPhase.CONNECTED, number.orElse(call.number()));
        sounds.connected();
        changed();
    }

    void callEnded(Cause cause) {
        call = call.over(cause);
        sounds.callEnded(cause);
        changed();
    }

    /** The network takes no keys. @return those that have not left */
    String keysRefused(Cause cause) {
        screens.note(Note.Kind.KEYS_REFUSED, String.valueOf(cause.code()));
        String rest = line.drop();
        changed();
        return rest;
    }

    void messageSent(int id, int parts) {
        mailbox.sent(id, parts);
        changed();
    }

    void messageFailed(int id, RpCause cause) {
        if (!mailbox.failed(id, cause)) {
            failedEarly.put(id, cause);
        }
        changed();
    }

    void messageDelivered(int id) {
        mailbox.delivered(id);
        changed();
    }

    void messageUndelivered(int id) {
        mailbox.undelivered(id);
        changed();
    }

    void messageReceived(String from, String text) {
        mailbox.received(from, text, wallClock.instant());
        screens.added(Box.INBOX);
        changed();
    }

    void broadcastReceived(int channel, int pages, String text) {
        mailbox.broadcast(channel, pages, text, wallClock.instant());
        screens.added(Box.BROADCASTS);
        changed();
    }

    private boolean isPowered() {
        return station.snapshot().powered();
    }

    /** Publishes what is now. */
    void changed() {
        call = call.at((int) (callFrames / FRAMES_PER_SECOND));
        newest = new HandsetSnapshot(
                own,
                station.snapshot(),
                call,
                home.typed(),
                screens.current(),
                mailbox.in(Box.INBOX),
                mailbox.in(Box.OUTBOX),
                mailbox.in(Box.BROADCASTS),
                keyMode,
                sounds.sounding(),
                sounds.trace(),
                sounds.isAudible());
    }
}
