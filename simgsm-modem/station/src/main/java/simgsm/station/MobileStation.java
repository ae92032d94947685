package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import simgsm.abis.IpaFrame;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;
import simgsm.octets.OctetString;
import simgsm.sim.PinLock;
import simgsm.sms.ChannelList;
import simgsm.speech.SpeechCodec;
import simgsm.station.call.AddedSpeech;
import simgsm.station.call.KeySignalling;
import simgsm.station.call.MediaControl;
import simgsm.station.call.MobileCall;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.call.SpeechPath;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.StationTimer;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.MobileRegistration;
import simgsm.station.mobility.MobilityMessages;
import simgsm.station.mobility.ServiceRequests;
import simgsm.station.mobility.Sim;
import simgsm.station.sms.ShortMessages;
import simgsm.station.ss.MobileUssd;

/**
 * A mobile station as a deterministic core: input is frames, commands and time, output is frames and {@link
 * StationEvent}s. It has no thread, clock or socket. One owner thread calls everything except {@link #snapshot};
 * commands happen at the time of the last call that had one.
 */
public final class MobileStation implements StationCommands {
    /** {@link #nextDeadlineNanos} without a deadline. */
    public static final long NO_DEADLINE = Long.MAX_VALUE;

    private final StationContext context;
    private final ConnectionControl control;
    private final PinLock lock;
    private final MobileRegistration registration;
    private final ServiceRequests services;
    private final MobilityMessages mobility;
    private final SpeechPath speech;
    private final KeySignalling keys;
    private final MobileCall call;
    private final ShortMessages messages;
    private final MobileUssd ussd;
    private final MediaControl media;
    private final MessageDispatcher dispatcher;
    private final CellReception reception;
    /** A card that demands nothing is not reported. */
    private PinLock.Status toldCard = PinLock.none().status();

    private boolean linkUp;
    private volatile StationSnapshot snapshot;

    /** A station that is switched on and not connected. */
    public MobileStation(
            StationIdentity identity,
            Sim sim,
            StationOptions options,
            SpeechSource speech,
            Consumer<StationEvent> listener) {
        this(identity, sim, options, speech, listener, RandomGenerator.getDefault());
    }

    /**
     * As above.
     *
     * @param random for the first message reference, the synchronisation source of the speech stream, and the time of
     *     the first periodic update
     */
    public MobileStation(
            StationIdentity identity,
            Sim sim,
            StationOptions options,
            SpeechSource speech,
            Consumer<StationEvent> listener,
            RandomGenerator random) {
        context = StationContext.of(identity, listener, this::settle);
        lock = sim.lock();
        registration = new MobileRegistration(context, lock, random);
        control = new ConnectionControl(context, registration::cellFound);
        services = new ServiceRequests(context, registration);
        mobility = new MobilityMessages(context, registration, services, sim);
        this.speech = new SpeechPath(context, options.codec(), options.recorder(), speech, random.nextInt());
        keys = new KeySignalling(context);
        call = new MobileCall(context, services, this.speech, keys, options.callWaiting(), options.ignoresSetup());
        messages = new ShortMessages(context, services, random.nextInt(256));
        services.setUser(ServiceType.MOBILE_ORIGINATED_CALL, call);
        services.setUser(ServiceType.EMERGENCY_CALL, call);
        media = new MediaControl(context);
        ussd = new MobileUssd(context, services);
        services.setUser(ServiceType.SHORT_MESSAGE, messages.sender());
        services.setUser(ServiceType.SUPPLEMENTARY_SERVICE, ussd);
        reception = new CellReception(context);
        dispatcher =
                new MessageDispatcher(context, registration, services, mobility, call, keys, messages, ussd, reception);
        snapshot = current();
    }

    @Override
    public StationIdentity identity() {
        return context.identity();
    }

    /** The link to the centre is established. */
    public void linkUp(Uplink uplink, long nowNanos) {
        timePassed(nowNanos);
        linkUp = true;
        context.radio().setUplink(uplink);
        control.linkUp();
        settle();
    }

    /** The link is lost, or an attempt to connect has failed. */
    public void linkDown(long nowNanos) {
        timePassed(nowNanos);
        linkUp = false;
        reception.lost();
        context.radio().setUplink(Uplink.DISCONNECTED);
        control.linkDown();
        mobility.forgetNetwork();
        // The end of a call is reported before the loss of service.
        call.lost();
        registration.linkLost();
        messages.linkLost();
        services.linkLost();
        settle();
    }

    public void frameArrived(IpaFrame frame, long nowNanos) {
        timePassed(nowNanos);
        control.heard();
        switch (frame.stream()) {
            case IpaFrame.RSL -> dispatcher.arrived(frame.payload());
            case IpaFrame.SPEECH -> speech.arrived(frame.payload());
            case IpaFrame.MGCP -> media.arrived(frame.payload());
            case IpaFrame.CCM -> control.arrived(frame.payload());
            default -> context.log().trace(Level.DEBUG, "a frame of stream {0} dropped", frame.stream());
        }
        settle();
    }

    /** Runs the timers that have expired; may be called at any time. */
    public void timePassed(long nowNanos) {
        context.timers().advanceTo(nowNanos);
    }

    /** Time of the next call of {@link #timePassed}, or {@link #NO_DEADLINE}. */
    public long nextDeadlineNanos() {
        return context.timers().nextDeadlineNanos().orElse(NO_DEADLINE);
    }

    /** Sets an action that runs whenever {@link #nextDeadlineNanos} becomes earlier. */
    void onEarlierDeadline(Runnable action) {
        context.timers().unnamed().onEarlier(action);
    }

    @Override
    public void powerOn() {
        registration.powerOn();
        settle();
    }

    @Override
    public void powerOff() {
        if (registration.isPowered()) {
            call.powerOff();
            messages.powerOff();
            ussd.powerOff();
            registration.powerOff();
            settle();
        }
    }

    @Override
    public PinLock.Result useCard(Function<PinLock, PinLock.Result> command) {
        PinLock.Result result = registration.isPowered() ? command.apply(lock) : PinLock.Result.REFUSED;
        settle();
        return result;
    }

    @Override
    public boolean dial(Msisdn number) {
        boolean isPermitted = registration.isPowered() && (lock.status().isReady() || number.isEmergency());
        return settled(isPermitted && call.dial(number));
    }

    @Override
    public void hideNumber(boolean hides) {
        call.hideNumber(hides);
    }

    @Override
    public boolean answer() {
        return settled(call.answer());
    }

    @Override
    public boolean hangUp() {
        return settled(call.hangUp());
    }

    /** Ends the call with this cause. @return false if there is none */
    public boolean clear(Cause cause) {
        return settled(call.clear(cause));
    }

    @Override
    public void signalKey(DtmfKey key, int millis) {
        keys.press(key, millis);
        settle();
    }

    @Override
    public void holdKey(DtmfKey key) {
        keys.hold(key);
        settle();
    }

    @Override
    public void releaseKey() {
        keys.letGo();
        settle();
    }

    @Override
    public int sendMessage(Msisdn to, String text) {
        return queued(messages.send(to, text));
    }

    /** Fails a queued message of a station that is switched off. */
    private int queued(int id) {
        if (!registration.isPowered()) {
            messages.powerOff();
        }
        settle();
        return id;
    }

    @Override
    public boolean sendUssd(String text) {
        return settled(registration.isPowered() && ussd.send(text));
    }

    /** True if the network waits for the reply in a USSD dialogue that it has begun. */
    public boolean isAskedByNetwork() {
        return ussd.isAskedByNetwork();
    }

    @Override
    public boolean endUssd() {
        return settled(ussd.end());
    }

    @Override
    public int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter) {
        return queued(messages.submit(tpdu, to, serviceCenter));
    }

    @Override
    public boolean rejectWaiting() {
        return settled(call.clearSecond());
    }

    @Override
    public boolean hold() {
        return settled(call.hold());
    }

    @Override
    public void setMemoryAvailable(boolean available) {
        messages.setMemoryAvailable(available);
        settle();
    }

    /** Lets {@link #messageTaken} and {@link #messageRefused} answer each text, for which its last part waits. */
    public void answerMessagesLater() {
        messages.answersLater();
    }

    /** Acknowledges the text of the last {@link StationEvent.ShortMessageReceived}. */
    public void messageTaken() {
        messages.messageTaken();
        settle();
    }

    /** Refuses the text of the last {@link StationEvent.ShortMessageReceived}; with memory exceeded (22) it comes again. */
    public void messageRefused(RpCause cause) {
        messages.messageRefused(cause);
        settle();
    }

    @Override
    public void setChannels(ChannelList channels) {
        messages.setChannels(channels);
    }

    /** Sets the speech that is sent beside the station's own. */
    public void setAdded(AddedSpeech added) {
        speech.setAdded(added);
    }

    @Override
    public void setCodec(SpeechCodec.Kind codec) {
        speech.setCodec(codec);
        settle();
    }

    /** The time of the last call that had one. */
    public long nowNanos() {
        return context.timers().nowNanos();
    }

    /** Requests one {@link StationEvent.AnswerDue} after this time, unless the call stops ringing before. */
    public void remindToAnswer(long nanos) {
        call.remindToAnswer(nanos);
    }

    /** Requests one {@link StationEvent.ReminderDue} in 30 s, unless one is pending. */
    public void remind() {
        if (!context.timers().isRunning(StationTimer.REMINDER)) {
            context.timers().start(StationTimer.REMINDER, () -> context.events().add(new StationEvent.ReminderDue()));
        }
    }

    @Override
    public StationSnapshot snapshot() {
        return snapshot;
    }

    /** True if the link may be closed: there is none, or the station is off and detached. */
    boolean isDetached() {
        return registration.isOff() || !linkUp;
    }

    private boolean settled(boolean result) {
        settle();
        return result;
    }

    /** Called after each change: supervises the channel, publishes the snapshot, delivers the events. */
    private void settle() {
        call.checkService();
        if (!context.radio().isOpen()) {
            registration.keepLocation();
        }
        services.superviseChannel(call.state() != MobileCallState.NULL || messages.isBusy());
        StationSnapshot now = current();
        if (!now.card().equals(toldCard)) {
            toldCard = now.card();
            context.events().add(new StationEvent.SimStateChanged(toldCard.state(), toldCard.tries()));
        }
        if (!now.equals(snapshot)) {
            snapshot = now;
            context.events().add(new StationEvent.StationChanged());
        }
        context.events().deliver();
    }

    private StationSnapshot current() {
        return new StationSnapshot(
                registration.isPowered(),
                linkUp,
                registration.isRegistered(),
                registration.rejectCause(),
                registration.isCardRefused(),
                mobility.networkName(),
                call.state(),
                call.peer(),
                Optional.of(speech.codec()),
                speech.heardCodec(),
                reception.cell(),
                lock.status());
    }
}
