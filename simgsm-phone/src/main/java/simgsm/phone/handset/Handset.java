package simgsm.phone.handset;

import java.time.InstantSource;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.phone.handset.Screen.Note;
import simgsm.speech.AudioOutput;
import simgsm.station.SpeechSource;
import simgsm.station.StationListener;
import simgsm.station.StationSnapshot;

/**
 * The phone. The station tells it what happens and asks it for speech; console and window ask it to act; all of that on
 * the station's owner thread. {@link #snapshot} may be asked by any thread.
 */
public final class Handset {
    private static final int MAX_TYPED = 40;
    private static final int FRAMES_PER_SECOND = 50;
    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    /** A key held this long does its second task: 1 opens the mailbox, 0 becomes a plus sign. */
    private static final long LONG_PRESS_NANOS = TimeUnit.MILLISECONDS.toNanos(800);
    /** For local sound that the station's news begin: they come without a time. */
    private static final long WHEN_TIME_IS_TOLD = Long.MIN_VALUE;
    /** So long the scope goes on after a tone, until its picture is quiet. */
    private static final int TAIL_FRAMES = 8;

    private final Msisdn own;
    private final HandsetListener listener;
    private final InstantSource wallClock;
    private final Earpiece earpiece;
    private final Mailbox mailbox = new Mailbox();
    private final Screens screens = new Screens(mailbox, new ScreenDeeds());
    private final KeySender line;
    private final KeySender local = new KeySender(keys -> {});
    private final DtmfReceiver ear = new DtmfReceiver(this::toneHeard);
    private final SupervisoryTonePlayer supervisory = new SupervisoryTonePlayer();
    private final short[] localFrame = new short[160];

    /** References of messages that failed while they were being handed in. */
    private final Set<Integer> failedEarly = new HashSet<>();

    private StationSide station;
    private CallSnapshot call = CallSnapshot.NONE;
    private long callFrames;
    private String typed = "";
    private String lastNumber = "";
    private PhoneKey heldKey;
    private long heldSinceNanos;
    private long nextLocalFrameNanos = Long.MAX_VALUE;
    private int tailFrames;
    private Runnable whenSettled;
    private Runnable timeWanted = () -> {};
    private volatile HandsetSnapshot newest;

    /**
     * A handset that waits for its station.
     *
     * @param wallClock for the time that messages came
     */
    public Handset(Msisdn own, HandsetListener listener, AudioOutput output, InstantSource wallClock) {
        this.own = own;
        this.listener = listener;
        this.wallClock = wallClock;
        this.earpiece = new Earpiece(output);
        this.line = new KeySender(listener::sent);
    }

    /** Gives the handset its station, once, before anything else. */
    public void attach(StationSide newStation) {
        station = newStation;
        changed();
    }

    /** What the station tells the handset. */
    public StationListener ears() {
        return new Ears();
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
        if (call.phase() != CallPhase.NONE) {
            return Optional.of(Refusal.CALL_UNDER_WAY);
        }
        if (!isPowered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        lastNumber = number.digits();
        return station.dial(number) ? Optional.empty() : Optional.of(Refusal.CALL_UNDER_WAY);
    }

    public Optional<Refusal> answer() {
        return station.answer() ? Optional.empty() : Optional.of(Refusal.NOTHING_RINGS);
    }

    public Optional<Refusal> hangUp() {
        line.drop();
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
        line.press(keys);
        keys.forEach(key -> keyed(key.symbol()));
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
        if (failedEarly.remove(id)) {
            mailbox.failed(id);
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
        line.drop();
        station.powerOff();
        typed = "";
        changed();
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

    private void checkSettled() {
        if (whenSettled != null && line.isIdle() && !mailbox.hasUnacknowledged()) {
            Runnable act = whenSettled;
            whenSettled = null;
            act.run();
        }
    }

    /** A sound device may come or go at any time; asked now and then, so that the view tells. */
    public void lookAtSound() {
        if (earpiece.isAudible() != newest.audible()) {
            changed();
        }
    }

    // Keys of the window.

    /** A key goes down; it sounds until {@link #keyUp}. */
    public void keyDown(PhoneKey key, long nowNanos) {
        timePassed(nowNanos);
        heldKey = key;
        heldSinceNanos = nowNanos;
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
            pressAtHome(key, nowNanos);
        } else {
            screens.press(key, nowNanos);
        }
        changed();
    }

    /** The key goes up again. */
    public void keyUp(PhoneKey key, long nowNanos) {
        timePassed(nowNanos);
        line.up();
        local.up();
        if (heldKey == key) {
            heldKey = null;
        }
        changed();
    }

    /** A character of a keyboard goes down: a letter while writing, else the key of that name. */
    public void charDown(char character, long nowNanos) {
        Optional<PhoneKey> key = PhoneKey.ofSymbol(character);
        if (isPowered() && screens.type(character)) {
            changed();
        } else if (isPowered() && character == '+' && screens.isHome() && call.phase() == CallPhase.NONE) {
            typed = typed.isEmpty() ? "+" : typed;
            changed();
        } else if (key.isPresent()) {
            keyDown(key.get(), nowNanos);
        }
    }

    /** Whatever character was down goes up. */
    public void charUp(char character, long nowNanos) {
        PhoneKey.ofSymbol(character).ifPresent(key -> keyUp(key, nowNanos));
    }

    private void pressAtHome(PhoneKey key, long nowNanos) {
        call = call.withoutEnd();
        if (call.phase() == CallPhase.NONE) {
            supervise(SupervisoryTone.NONE);
        }
        switch (key) {
            case CALL -> callTyped();
            case OK -> {
                if (call.phase() == CallPhase.RINGING) {
                    answer();
                } else if (typed.isEmpty()) {
                    screens.openMenu();
                } else {
                    callTyped();
                }
            }
            case END -> typed = "";
            case LEFT -> typed = typed.isEmpty() ? "" : typed.substring(0, typed.length() - 1);
            case MENU -> screens.openMenu();
            case MESSAGE -> screens.write();
            case DOWN -> screens.open(Box.INBOX);
            case UP -> screens.open(Box.OUTBOX);
            case RIGHT -> {}
            default -> key.tone().ifPresent(tone -> sound(tone, nowNanos));
        }
    }

    private void sound(DtmfKey tone, long nowNanos) {
        if (call.phase() == CallPhase.CONNECTED) {
            line.down(tone);
            keyed(tone.symbol());
            return;
        }
        local.down(tone);
        soundLocally(nowNanos);
        if (call.phase() == CallPhase.NONE && typed.length() < MAX_TYPED) {
            typed += tone.symbol();
        }
    }

    /** Begins to give frames to the ear without a call's beat. */
    private void soundLocally(long nowNanos) {
        nextLocalFrameNanos = Math.min(nextLocalFrameNanos, nowNanos);
        tailFrames = TAIL_FRAMES;
    }

    private void callTyped() {
        if (call.phase() != CallPhase.NONE) {
            return;
        }
        if (typed.isEmpty()) {
            typed = lastNumber;
        } else {
            dialText(typed);
        }
    }

    private void dialText(String number) {
        if (!Screens.isNumber(number)) {
            screens.note(Note.Kind.NOT_A_NUMBER, number);
        } else if (dial(Msisdn.parse(number)).isPresent()) {
            screens.note(Note.Kind.REFUSED, number);
        }
    }

    // Time, for what happens without a call: key tones, letters, long presses.

    /** Whether {@link #timePassed} is to be called within the next 20 ms; may become true by acts and by the station. */
    public boolean wantsTime() {
        return nextLocalFrameNanos == WHEN_TIME_IS_TOLD
                || nextLocalFrameNanos != Long.MAX_VALUE
                || screens.wantsTime()
                || canBeLongPress();
    }

    /** Has the act run whenever the station's news make the handset want time. */
    public void whenTimeIsWanted(Runnable act) {
        timeWanted = act;
    }

    public void timePassed(long nowNanos) {
        boolean changed = screens.timePassed(nowNanos);
        if (nextLocalFrameNanos == WHEN_TIME_IS_TOLD) {
            nextLocalFrameNanos = nowNanos;
        }
        while (nextLocalFrameNanos <= nowNanos) {
            changed |= localFrame();
        }
        if (canBeLongPress() && nowNanos - heldSinceNanos >= LONG_PRESS_NANOS) {
            longPress();
            changed = true;
        }
        if (changed) {
            changed();
        }
    }

    private boolean localFrame() {
        if (call.phase() == CallPhase.CONNECTED) {
            local.drop();
            nextLocalFrameNanos = Long.MAX_VALUE;
            return true;
        }
        DtmfKey before = local.sounding();
        local.read(localFrame);
        supervisory.addTo(localFrame);
        earpiece.said(localFrame);
        tailFrames = local.isIdle() && supervisory.isIdle() ? tailFrames - 1 : TAIL_FRAMES;
        nextLocalFrameNanos = tailFrames > 0 ? nextLocalFrameNanos + FRAME_NANOS : Long.MAX_VALUE;
        return earpiece.pollChanged() || before != local.sounding();
    }

    private boolean canBeLongPress() {
        return screens.isHome()
                && call.phase() == CallPhase.NONE
                && (heldKey == PhoneKey.ONE && typed.equals("1") || heldKey == PhoneKey.ZERO && typed.equals("0"));
    }

    private void longPress() {
        local.up();
        if (heldKey == PhoneKey.ONE) {
            typed = "";
            screens.open(Box.INBOX);
        } else {
            typed = "+";
        }
        heldKey = null;
    }

    // Speech.

    private void say(short[] frame) {
        if (call.phase() != CallPhase.CONNECTED) {
            SpeechSource.SILENCE.read(frame);
            return;
        }
        DtmfKey before = line.sounding();
        line.read(frame);
        earpiece.said(frame);
        callFrames++;
        if (earpiece.pollChanged() || before != line.sounding() || callFrames % FRAMES_PER_SECOND == 0) {
            changed();
        }
        checkSettled();
    }

    private void toneHeard(DtmfDigit digit) {
        call = call.withHeard(digit.key().symbol());
        listener.toneHeard(digit.key());
        changed();
    }

    private void keyed(char symbol) {
        call = call.withKeyed(symbol);
    }

    private void supervise(SupervisoryTone tone) {
        supervisory.start(tone);
        if (tone != SupervisoryTone.NONE) {
            soundLocally(WHEN_TIME_IS_TOLD);
            timeWanted.run();
        }
    }

    private boolean isPowered() {
        return station.snapshot().powered();
    }

    private void changed() {
        StationSnapshot state = station.snapshot();
        DtmfKey sounding = call.phase() == CallPhase.CONNECTED ? line.sounding() : local.sounding();
        call = call.at((int) (callFrames / FRAMES_PER_SECOND));
        newest = new HandsetSnapshot(
                own,
                state,
                call,
                typed,
                screens.current(),
                mailbox.in(Box.INBOX),
                mailbox.in(Box.OUTBOX),
                mailbox.in(Box.BROADCASTS),
                Optional.ofNullable(sounding),
                earpiece.trace(),
                earpiece.isAudible());
    }

    private void beginCall(CallPhase phase, String number) {
        call = CallSnapshot.begun(phase, number);
        callFrames = 0;
        typed = "";
        line.drop();
        supervise(SupervisoryTone.NONE);
        screens.home();
        changed();
    }

    private void advanceCall(CallPhase phase, String number) {
        call = call.in(phase, number);
        changed();
    }

    private final class ScreenDeeds implements Screens.Deeds {
        @Override
        public void dial(String number) {
            dialText(number);
        }

        @Override
        public boolean send(Msisdn to, String text) {
            boolean refused = sendMessage(to, text).isPresent();
            if (refused) {
                screens.note(Note.Kind.REFUSED, to.digits());
            }
            return !refused;
        }

        @Override
        public void switchOff() {
            powerOff();
        }
    }

    private final class Ears implements StationListener {
        @Override
        public void registered(Msisdn number) {
            listener.registered(number);
            changed();
        }

        @Override
        public void unregistered(Optional<RejectCause> cause) {
            listener.unregistered(cause);
            changed();
        }

        @Override
        public void calling(Msisdn number) {
            beginCall(CallPhase.CALLING, number.digits());
            listener.calling(number);
        }

        @Override
        public void alerting() {
            advanceCall(CallPhase.ALERTING, call.number());
            supervise(SupervisoryTone.RINGING);
            listener.alerting();
        }

        @Override
        public void ringing(Optional<Msisdn> from) {
            String number = from.map(Msisdn::digits).orElse("");
            beginCall(CallPhase.RINGING, number);
            lastNumber = number.isEmpty() ? lastNumber : number;
            supervise(SupervisoryTone.INCOMING);
            listener.ringing(from);
        }

        @Override
        public void connected(Optional<Msisdn> peer) {
            ear.reset();
            supervise(SupervisoryTone.NONE);
            advanceCall(CallPhase.CONNECTED, peer.map(Msisdn::digits).orElse(call.number()));
            listener.connected(peer);
        }

        @Override
        public void released(Cause cause) {
            line.drop();
            earpiece.callEnded();
            call = call.over(cause);
            supervise(SupervisoryTone.of(cause));
            listener.released(cause);
            changed();
            checkSettled();
        }

        @Override
        public void speechReceived(short[] samples) {
            if (call.phase() == CallPhase.CONNECTED) {
                earpiece.heard(samples);
                ear.accept(samples);
            }
        }

        @Override
        public void messageSent(int id, Msisdn to, int parts) {
            mailbox.sent(id, parts);
            listener.messageSent(to, parts, id);
            changed();
            checkSettled();
        }

        @Override
        public void messageFailed(int id, Msisdn to, RpCause cause) {
            if (!mailbox.failed(id)) {
                failedEarly.add(id);
            }
            listener.messageFailed(to, cause);
            changed();
            checkSettled();
        }

        @Override
        public void messageReceived(String from, String text) {
            mailbox.received(from, text, wallClock.instant());
            screens.added(Box.INBOX);
            listener.messageReceived(from, text);
            changed();
        }

        @Override
        public void messageDelivered(int id, Msisdn to) {
            mailbox.delivered(id);
            listener.messageDelivered(to, id);
            changed();
        }

        @Override
        public void broadcastReceived(int channel, int pages, String text) {
            mailbox.broadcast(channel, pages, text, wallClock.instant());
            screens.added(Box.BROADCASTS);
            listener.broadcastReceived(channel, pages, text);
            changed();
        }

        @Override
        public void stateChanged(StationSnapshot snapshot) {
            changed();
        }
    }
}
