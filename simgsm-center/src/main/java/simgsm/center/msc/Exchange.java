package simgsm.center.msc;

import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.air.MobilityManagement.MmInformation;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.center.bsc.BaseStationController;
import simgsm.center.bsc.CellSettings;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallSwitch;
import simgsm.center.msc.call.CallView;
import simgsm.center.msc.call.NetworkCall;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.center.msc.link.PeerUser;
import simgsm.center.msc.link.TerminalAccess;
import simgsm.center.msc.mobility.MobilityProcedures;
import simgsm.center.msc.sms.MobileMessages;
import simgsm.center.msc.ss.UserReports;
import simgsm.center.msc.ss.UssdDialogues;
import simgsm.center.smsc.ApplicationPort;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.MessageStore;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.smsc.StoredState;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.subscriber.SubscriberRegister;
import simgsm.lesson.LessonLibrary;
import simgsm.lesson.StepResult;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/**
 * The centre without sockets and clock: base station controller, MSC, registers and SMSC in one deterministic machine.
 * Inputs are links, frames, commits and time; outputs are frames, closings and events, through {@link LinkPort}, {@link
 * MessageStore} and the listener. One thread drives it. Every {@code nowNanos} counts from the exchange's start.
 */
public final class Exchange {
    private static final System.Logger LOG = System.getLogger(Exchange.class.getName());

    private final Timers timers = new Timers();
    private final CivilTime civil;
    private final Consumer<ExchangeEvent> listener;
    private final SubscriberRegister register;
    private final MobilityProcedures mobility;
    private final CallSwitch calls;
    private final ShortMessageCenter shortMessages;
    private final Broadcaster broadcaster;
    private final SignallingDispatcher signalling;
    private final SnapshotMaker snapshots;
    private final Link.Context links;
    private final BaseStationController controller;
    private final boolean speaksUdp;
    private LessonLibrary lessons = LessonLibrary.ofSuite();

    /** An exchange without applications. */
    public Exchange(ExchangeSettings settings, MessageStore store, Consumer<ExchangeEvent> listener) {
        this(settings, store, ApplicationPort.NONE, listener);
    }

    /** @param listener called on the driving thread */
    public Exchange(
            ExchangeSettings settings,
            MessageStore store,
            ApplicationPort applications,
            Consumer<ExchangeEvent> listener) {
        civil = new CivilTime(settings.startedAt(), timers);
        this.listener = listener;
        RandomGenerator random = settings.random();
        Ladder ladder = new Ladder(civil);
        register = new SubscriberRegister(
                settings.home(),
                random,
                first -> store.commit(
                        MessageStore.NO_TICKET, List.of(new StoreEntry.Known(first.number(), first.imsi()))));
        Supplier<MmInformation> information =
                () -> new MmInformation(settings.networkName(), Optional.of(civil.local()));
        mobility =
                new MobilityProcedures(register, random, information, this::attached, this::detached, this::reachable);
        Function<Msisdn, Optional<Link>> locations =
                number -> register.ofNumber(number).flatMap(mobility::locationOf);
        MobileMessages mobiles = new MobileMessages(locations, settings.home()::shown);
        UssdDialogues services =
                new UssdDialogues(locations, settings.language(), settings.callWaiting(), reports(), this::store);
        shortMessages = new ShortMessageCenter(
                civil, timers, store, new DeliverySelector(mobiles, applications, register), this::messageChanged);
        mobiles.serve(shortMessages);
        calls = new CallSwitch(
                mobility, settings.tones(), settings.callWaiting(), settings.setupNanos(), this::callChanged);
        calls.setEmergencyNumber(settings.emergencyNumber());
        broadcaster = new Broadcaster(mobility, timers, random);
        signalling = new SignallingDispatcher(mobility, calls, mobiles, services, ladder);
        links = new Link.Context(
                timers,
                ladder,
                new LinkedHashSet<>(),
                new LinkedHashSet<>(),
                List.of(mobility, calls, mobiles, services));
        speaksUdp = settings.speaksUdp();
        CellSettings cells = CellSettings.with(settings.handover());
        mobility.detachSilentAfter(cells.implicitDetachNanos());
        controller = new BaseStationController(links, signalling, cells, mobility::linkOf, mobility::mustProve);
        snapshots = new SnapshotMaker(register, calls, shortMessages, ladder, broadcaster);
    }

    /** Sets the handover algorithm of calls over towers, from their next traffic channel on. */
    public void setHandover(HandoverAlgorithm handover) {
        controller.setHandover(handover);
    }

    /** Sets the lessons whose results phones may tell, instead of the suite's. */
    public void markLessons(LessonLibrary library) {
        lessons = library;
    }

    private UserReports reports() {
        return new UserReports() {
            @Override
            public void named(Msisdn number, String name) {
                report(new ExchangeEvent.Named(number, name));
            }

            @Override
            public boolean lessonResult(Msisdn number, StepResult result) {
                boolean isKnown = lessons.hasStep(result.lesson(), result.step());
                if (isKnown) {
                    report(new ExchangeEvent.LessonResult(number, result));
                }
                return isKnown;
            }
        };
    }

    /** Tells the operator of something that happened outside the network. */
    public void report(ExchangeEvent event) {
        listener.accept(event);
    }

    /** Takes over what the store held at the start. To be called once, before all other methods. */
    public void restore(StoredState stored) {
        stored.subscribers().forEach(known -> register.restore(known.number(), known.imsi(), known.services()));
        shortMessages.restore(stored);
    }

    private void store(Subscriber changed, Consumer<Boolean> stored) {
        String services = changed.services().text();
        shortMessages.commit(new StoreEntry.Known(changed.number(), changed.imsi(), services), stored);
    }

    private void attached(Subscriber subscriber) {
        listener.accept(new ExchangeEvent.Attached(subscriber.number()));
        shortMessages.available(subscriber.number());
    }

    private void reachable(Subscriber subscriber) {
        shortMessages.available(subscriber.number());
    }

    private void detached(Subscriber subscriber) {
        listener.accept(new ExchangeEvent.Detached(subscriber.number()));
    }

    private void callChanged(NetworkCall call) {
        if (call.state() == CallProgress.INITIATED) {
            snapshots.callBegan(CallView.of(call));
            calls.keyTap().follow(call);
        } else if (call.state() == CallProgress.RELEASED) {
            snapshots.callEnded(CallView.of(call));
        }
        call.to()
                .ifPresent(to -> listener.accept(
                        new ExchangeEvent.CallChanged(call.id(), call.from(), to, call.state(), call.cause())));
    }

    private void messageChanged(ShortMessage message, MessageState state) {
        if (state == MessageState.ACCEPTED) {
            snapshots.messageAccepted(message);
        }
        listener.accept(new ExchangeEvent.MessageChanged(message.id(), message.from(), message.to(), state));
    }

    /** A terminal or tower on this machine has connected. The peer identifies it in all further calls. */
    public Peer linkOpened(long nowNanos, LinkPort port, String address) {
        return linkOpened(nowNanos, port, address, true);
    }

    /**
     * A terminal or tower has connected.
     *
     * @param isLocal true if it runs on this machine, without rate limits
     */
    public Peer linkOpened(long nowNanos, LinkPort port, String address, boolean isLocal) {
        advanceTimers(nowNanos);
        Peer peer = new Peer(port, address, isLocal, timers, this::terminal, this::tower);
        peer.open();
        settle();
        return peer;
    }

    private PeerUser terminal(Peer peer) {
        return new TerminalAccess(peer, links, signalling, speaksUdp);
    }

    private PeerUser tower(Peer peer, CcmMessage.IdentityResponse identity) {
        return controller.towerConnected(peer, identity);
    }

    public void frameReceived(long nowNanos, Peer peer, IpaFrame frame) {
        advanceTimers(nowNanos);
        if (!peer.isClosed()) {
            try {
                peer.received(frame);
            } catch (ProtocolViolation violation) {
                peer.violated(violation.getMessage());
            }
        }
        settle();
    }

    /** The connection was closed by the peer, or is broken. */
    public void linkClosed(long nowNanos, Peer peer, String reason) {
        advanceTimers(nowNanos);
        peer.lost(reason);
        settle();
    }

    /** Performs an action at this time. */
    public void perform(long nowNanos, Runnable action) {
        advanceTimers(nowNanos);
        action.run();
        settle();
    }

    /** The store's answer to a commit. */
    public void committed(long nowNanos, long ticket, boolean isDurable) {
        advanceTimers(nowNanos);
        try {
            shortMessages.committed(ticket, isDurable);
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "an error of our own after a commit", e);
        }
        settle();
    }

    /** Advances the time. */
    public void advance(long nowNanos) {
        advanceTimers(nowNanos);
        settle();
    }

    /** Sets the wall clock: time stamps and validities follow it, timers do not. */
    public void clockShows(long nowNanos, Instant wall) {
        advanceTimers(nowNanos);
        if (civil.isJump(wall)) {
            shortMessages.timeHasJumped();
            advance(nowNanos);
        }
    }

    /** The latest time for the next {@link #advance}. */
    public OptionalLong nextDeadlineNanos() {
        return timers.nextDeadlineNanos();
    }

    /** Connects held calls and releases unused channels, on the links with activity. */
    private void settle() {
        Set<Link> touched = links.touched();
        while (!touched.isEmpty()) {
            List<Link> portion = new ArrayList<>(touched);
            touched.clear();
            portion.forEach(calls::legsChanged);
            portion.forEach(Exchange::releaseIfUnused);
        }
    }

    private static void releaseIfUnused(Link link) {
        try {
            if (!link.isClosed()) {
                link.radio().releaseIfUnused();
            }
        } catch (RuntimeException e) {
            link.failed(e);
        }
    }

    /**
     * Advances the time. An internal error in a timer of a link or application ends that one; in any other timer it is
     * logged. It never reaches the caller, whose frame belongs to another link.
     */
    private void advanceTimers(long nowNanos) {
        boolean isDone = false;
        while (!isDone) {
            try {
                timers.advance(nowNanos);
                isDone = true;
            } catch (RuntimeException e) {
                LOG.log(Level.ERROR, "an error of our own in a timer", e);
            }
        }
    }

    /**
     * Broadcasts a text to all attached terminals, once or repeatedly.
     *
     * @throws IllegalArgumentException naming the invalid part of the order
     */
    public BroadcastView broadcast(long nowNanos, BroadcastOrder order) {
        advanceTimers(nowNanos);
        return broadcaster.broadcast(order);
    }

    /** @return false if no repeated broadcast has this id */
    public boolean stopBroadcast(int id) {
        return broadcaster.stop(id);
    }

    /** Repeated broadcasts, oldest first. */
    public List<BroadcastView> broadcasts() {
        return broadcaster.running();
    }

    // Views, for the driving thread only.

    public Collection<Subscriber> subscribers() {
        return register.all();
    }

    /** The subscriber as a row of a list. */
    public ExchangeSnapshot.SubscriberRow row(Subscriber subscriber) {
        return ExchangeSnapshot.SubscriberRow.of(subscriber, register.home().isBarred(subscriber.imsi()));
    }

    /** True if this number is listed, or has ever registered. */
    public boolean isKnown(Msisdn number) {
        return register.ofNumber(number).isPresent();
    }

    /** Calls under way, oldest first. */
    public List<CallView> calls() {
        return calls.calls().stream().map(CallView::of).toList();
    }

    /** Speech frames passed on since the start. */
    public long speechFrames() {
        return calls.speechFramesSwitched();
    }

    /** Attached subscribers. */
    public int attachedCount() {
        return register.attachedCount();
    }

    /** The connected towers, with the number of their free channels. */
    public Map<String, Long> towers() {
        return controller.freeChannels();
    }

    CallSwitch callSwitch() {
        return calls;
    }

    public ShortMessageCenter shortMessages() {
        return shortMessages;
    }

    public Timers timers() {
        return timers;
    }

    public int linkCount() {
        return links.open().size();
    }

    /** An immutable view of bounded size for a window. */
    public ExchangeSnapshot snapshot() {
        return snapshots.make(civil.now(), linkCount());
    }
}
