package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.random.RandomGenerator;
import simgsm.abis.IpaFrame;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.sms.ChannelList;

/**
 * A mobile station as a deterministic core: frames, acts and time in; frames and {@link StationListener} calls out. It has
 * no thread, clock or socket of its own. One owner calls everything except {@link #snapshot}; acts happen at the time that
 * the owner told last.
 */
public final class MobileStation {
    /** {@link #nextDeadlineNanos} of a station that waits for nothing. */
    public static final long NO_DEADLINE = Long.MAX_VALUE;

    private final StationParts parts;
    private final StationKeepAlive keepAlive;
    private final MobileRegistration registration;
    private final ServiceRequests services;
    private final MobilityMessages mobility;
    private final SpeechPath speech;
    private final KeySignalling keys;
    private final MobileCall call;
    private final ShortMessages messages;
    private final Dispatcher dispatcher;
    private boolean linkUp;
    private volatile StationSnapshot snapshot;

    /** A station that is switched on and has no link yet. */
    public MobileStation(
            StationIdentity identity, Sim sim, StationOptions options, SpeechSource speech, StationListener listener) {
        this(identity, sim, options, speech, listener, RandomGenerator.getDefault());
    }

    /** @param random gives the first message reference and the speech stream its number */
    public MobileStation(
            StationIdentity identity,
            Sim sim,
            StationOptions options,
            SpeechSource speech,
            StationListener listener,
            RandomGenerator random) {
        parts = new StationParts(identity, listener);
        registration = new MobileRegistration(parts);
        keepAlive = new StationKeepAlive(parts, registration::cellFound);
        services = new ServiceRequests(parts, registration);
        mobility = new MobilityMessages(parts, registration, services, sim);
        this.speech = new SpeechPath(parts, options, speech, random.nextInt());
        keys = new KeySignalling(parts);
        call = new MobileCall(parts, services, this.speech, keys);
        messages = new ShortMessages(parts, services, random.nextInt(256));
        services.setUser(ServiceType.MOBILE_ORIGINATED_CALL, call);
        services.setUser(ServiceType.SHORT_MESSAGE, messages.sender());
        dispatcher = new Dispatcher(parts, registration, services, mobility, call, keys, messages);
        snapshot = present();
    }

    public StationIdentity identity() {
        return parts.identity();
    }

    /** A connection to the centre is there. */
    public void linkUp(Uplink uplink, long nowNanos) {
        timePassed(nowNanos);
        linkUp = true;
        parts.radio().linkUp(uplink);
        speech.setUplink(uplink);
        keepAlive.linkUp(uplink);
        settle();
    }

    /** The connection is lost, or could not be made. */
    public void linkDown(long nowNanos) {
        timePassed(nowNanos);
        linkUp = false;
        parts.radio().linkDown();
        speech.setUplink(Uplink.DISCONNECTED);
        keepAlive.linkDown();
        mobility.forgetNetwork();
        // A call that the link took with it is released before the loss of service is told.
        call.lost();
        registration.linkLost();
        messages.linkLost();
        services.linkLost();
        settle();
    }

    public void frameArrived(IpaFrame frame, long nowNanos) {
        timePassed(nowNanos);
        keepAlive.heard();
        switch (frame.stream()) {
            case IpaFrame.RSL -> dispatcher.arrived(frame.payload());
            case IpaFrame.SPEECH -> speech.arrived(frame.payload());
            case IpaFrame.CCM -> keepAlive.arrived(frame.payload());
            default -> parts.log().trace(Level.DEBUG, "a frame of stream {0} dropped", frame.stream());
        }
        settle();
    }

    /** Does what is due; calling it early or often is harmless. */
    public void timePassed(long nowNanos) {
        parts.timers().advanceTo(nowNanos);
        for (var timer = parts.timers().expired();
                timer.isPresent();
                timer = parts.timers().expired()) {
            expired(timer.get());
            settle();
        }
    }

    /** When {@link #timePassed} is to be called next, or {@link #NO_DEADLINE}. */
    public long nextDeadlineNanos() {
        return parts.timers().nextDeadlineNanos();
    }

    public void powerOn() {
        registration.powerOn();
        settle();
    }

    /** Ends a call with cause 16, detaches and says unregistered. */
    public void powerOff() {
        if (registration.isPowered()) {
            call.powerOff();
            messages.powerOff();
            registration.powerOff();
            settle();
        }
    }

    /** Calls a number; without service the call waits for it some seconds. @return false if a call is already under way or the station is off, and nothing happens */
    public boolean dial(Msisdn number) {
        boolean dialled = registration.isPowered() && call.dial(number);
        settle();
        return dialled;
    }

    /** Takes the ringing call. @return false if none rings */
    public boolean answer() {
        boolean answered = call.answer();
        settle();
        return answered;
    }

    /**
     * Ends the call: {@link StationListener#released} says 16. The caller of a call that rings hears that it was rejected
     * (21). @return false if there is none
     */
    public boolean hangUp() {
        boolean cleared = call.hangUp();
        settle();
        return cleared;
    }

    /** Ends the call with this cause. @return false if there is none */
    public boolean clear(Cause cause) {
        boolean cleared = call.clear(cause);
        settle();
        return cleared;
    }

    /**
     * Signals a key to the network (START DTMF, STOP DTMF), which makes its sound for the far end: after those that wait, and
     * not before the call is active.
     *
     * @param millis how long it sounds; 70 at least
     */
    public void signalKey(DtmfKey key, int millis) {
        keys.press(key, millis);
        settle();
    }

    /** Signals a key that sounds until {@link #letGoKey}; one that is still held is let go. */
    public void holdKey(DtmfKey key) {
        keys.hold(key);
        settle();
    }

    /** The key that is held goes up; does nothing when none is. */
    public void letGoKey() {
        keys.letGo();
        settle();
    }

    /**
     * Queues a text, cut into as many parts as it needs; a status report is asked for. Without service it waits for a while.
     *
     * @return the message reference of the first part, 0 to 255
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    public int sendMessage(Msisdn to, String text) {
        int id = messages.send(to, text);
        if (!registration.isPowered()) {
            messages.powerOff();
        }
        settle();
        return id;
    }

    /** No room for messages: the network is told so (RP cause 22) when it brings one, and keeps it. */
    public void memoryFull() {
        messages.memoryFull();
    }

    /** Room again: if the network has been refused, it is told (RP-SMMA) and brings what it has kept. */
    public void memoryAvailable() {
        messages.memoryAvailable();
        settle();
    }

    /** Broadcasts on other channels are discarded from now on; at first all are wanted. */
    public void wantBroadcasts(ChannelList channels) {
        messages.wantBroadcasts(channels);
    }

    /** The time that the owner told last. */
    public long nowNanos() {
        return parts.timers().nowNanos();
    }

    /** Asks for one {@link StationListener#reminded} in half a minute; one that is asked for already comes instead. */
    public void remind() {
        if (!parts.timers().isRunning(StationTimer.REMINDER)) {
            parts.timers().start(StationTimer.REMINDER);
        }
    }

    /** The newest state; any thread may ask. */
    public StationSnapshot snapshot() {
        return snapshot;
    }

    /** Whether nothing is under way that a link should stay for: no call, no detaching. */
    boolean isDetached() {
        return registration.state() == MobileRegistrationState.NULL || !linkUp;
    }

    private void expired(StationTimer timer) {
        switch (timer) {
            case T3210 -> registration.t3210Expired();
            case T3211 -> registration.t3211Expired();
            case T3220 -> registration.t3220Expired();
            case T3230 -> services.t3230Expired();
            case T3240 -> leaveIdleChannel();
            case CALL_WAIT -> call.waitExpired();
            case T303 -> call.expired(MobileCallEvent.T303_EXPIRED);
            case T305 -> call.expired(MobileCallEvent.T305_EXPIRED);
            case T308 -> call.t308Expired();
            case T310 -> call.expired(MobileCallEvent.T310_EXPIRED);
            case T313 -> call.expired(MobileCallEvent.T313_EXPIRED);
            case TC1_OUTGOING, TC1_INCOMING, TR1M, MESSAGE_WAIT -> messages.expired(timer);
            case T336, T337, KEY -> keys.expired(timer);
            case SPEECH -> speak();
            case REMINDER -> parts.notifications().add(StationListener::reminded);
            case PING -> keepAlive.pingDue();
            case IDENTITY -> keepAlive.identityExpired();
        }
    }

    private void leaveIdleChannel() {
        parts.radio().release();
        services.channelLeft();
    }

    /** A call in which nothing comes any more is dead, even if nobody says so. */
    private void speak() {
        speech.frameDue();
        if (speech.isDead() && call.expectsSpeech()) {
            call.clear(Cause.TEMPORARY_FAILURE);
        }
    }

    /** The state is whole again: look after the idle channel, publish, tell. */
    private void settle() {
        call.lookAtService();
        watchIdleChannel();
        StationSnapshot now = present();
        if (!now.equals(snapshot)) {
            snapshot = now;
            parts.notifications().add(listener -> listener.stateChanged(now));
        }
        parts.notifications().deliver();
    }

    private void watchIdleChannel() {
        boolean idle = parts.radio().isOpen()
                && !registration.needsRadio()
                && (services.isAborting()
                        || services.isIdle() && call.state() == MobileCallState.NULL && !messages.isBusy());
        if (!idle) {
            parts.timers().stop(StationTimer.T3240);
        } else if (!parts.timers().isRunning(StationTimer.T3240)) {
            parts.timers().start(StationTimer.T3240);
        }
    }

    private StationSnapshot present() {
        return new StationSnapshot(
                registration.isPowered(),
                linkUp,
                registration.isRegistered(),
                registration.rejectCause(),
                registration.isCardRefused(),
                mobility.networkName(),
                call.state(),
                call.peer(),
                speech.codec(),
                speech.heardCodec());
    }
}
