package simgsm.center.msc;

import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import java.util.random.RandomGenerator;
import simgsm.abis.CcmCodec;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslCodec;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.center.smpp.SmppServer;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.MessageStore;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.smsc.StoredState;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.subscriber.SubscriberRegister;
import simgsm.timer.Timers;

/**
 * The centre without its sockets and its clock: base station controller, MSC, registers and SMSC in one deterministic
 * machine. Links, frames, commits and time go in; frames, closings and events come out, through {@link LinkPort},
 * {@link MessageStore} and {@link ExchangeListener}. One thread drives it. Every {@code nowNanos} counts from the
 * exchange's start.
 */
public final class Exchange {
    private static final System.Logger LOG = System.getLogger(Exchange.class.getName());

    private final Timers timers = new Timers();
    private final Ladder ladder;
    private final Set<Link> links = new LinkedHashSet<>();
    private final Set<Link> settlement = new LinkedHashSet<>();
    private final SubscriberRegister register;
    private final Mobility mobility;
    private final CallSwitch calls;
    private final ShortMessageCenter shortMessages;
    private final SmppServer smpp;
    private final Broadcaster broadcaster;
    private final SignallingDispatcher signalling;
    private final ExchangeParts parts;
    private final SnapshotMaker snapshots;
    private final Instant startedAt;

    public Exchange(ExchangeSettings settings, MessageStore store, ExchangeListener listener) {
        ladder = new Ladder(settings.startedAt(), timers);
        RandomGenerator random = settings.random();
        register = new SubscriberRegister(
                settings.home(),
                random,
                newcomer -> store.commit(
                        MessageStore.NO_TICKET, List.of(new StoreEntry.Known(newcomer.number(), newcomer.imsi()))));
        smpp = new SmppServer(timers);
        MessageDelivery delivery = new MessageDelivery(register);
        shortMessages = new ShortMessageCenter(
                settings.startedAt(),
                timers,
                store,
                new DeliveryWays(delivery, smpp.routes(), register),
                (message, state) -> messageChanged(message, state, listener));
        mobility = new Mobility(
                register,
                timers,
                random,
                settings.networkName(),
                new AttachmentEvents(listener, number -> shortMessages.available(number)));
        delivery.locations(mobility);
        smpp.serve(shortMessages);
        calls = new CallSwitch(
                mobility, timers, settings.tones(), settings.callWaiting(), call -> callChanged(call, listener));
        broadcaster = new Broadcaster(mobility, timers, random);
        signalling = new SignallingDispatcher(mobility, calls, ladder);
        parts = new ExchangeParts(timers, ladder, mobility, shortMessages, links, settlement);
        snapshots = new SnapshotMaker(register, calls, shortMessages, ladder, broadcaster);
        startedAt = settings.startedAt();
    }

    /** Goes on where an earlier life of this exchange ended. To be called once, before anything else. */
    public void restore(StoredState restored) {
        restored.subscribers().forEach(known -> register.restore(known.number(), known.imsi()));
        shortMessages.restore(restored);
    }

    private void callChanged(NetworkCall call, ExchangeListener listener) {
        if (call.state() == CallProgress.INITIATED) {
            snapshots.callBegan(CallView.of(call));
            calls.keyTap().follow(call);
        }
        call.to().ifPresent(to -> listener.happened(new ExchangeEvent.CallChanged(call.from(), to, call.state())));
    }

    private void messageChanged(ShortMessage message, MessageState state, ExchangeListener listener) {
        if (state == MessageState.ACCEPTED) {
            snapshots.messageAccepted(message);
        }
        smpp.changed(message, state);
        listener.happened(new ExchangeEvent.MessageChanged(message.id(), message.from(), message.to(), state));
    }

    /** A terminal of this machine has connected. The link stands for it in all further calls. */
    public Link linkOpened(long nowNanos, LinkPort port, String address) {
        return linkOpened(nowNanos, port, address, true);
    }

    /** A terminal has connected. @param isLocal whether from this machine: only others are held to what one person does */
    public Link linkOpened(long nowNanos, LinkPort port, String address, boolean isLocal) {
        advanceTimers(nowNanos);
        Link link = new Link(port, address, isLocal, parts);
        links.add(link);
        link.open();
        settle();
        return link;
    }

    public void frameReceived(long nowNanos, Link link, IpaFrame frame) {
        advanceTimers(nowNanos);
        if (!link.isClosed) {
            try {
                receive(link, frame);
            } catch (ProtocolViolation violation) {
                link.violated(violation.getMessage());
            }
        }
        settle();
    }

    /** The connection has ended by the peer's doing, or broke. */
    public void linkClosed(long nowNanos, Link link, String reason) {
        advanceTimers(nowNanos);
        if (!link.isClosed) {
            // Whoever has detached before may go without a word.
            LOG.log(link.subscriber == null ? Level.DEBUG : Level.INFO, "{0}: gone, {1}", link, reason);
            link.forget();
        }
        settle();
    }

    /** What applications say and hear; only within {@link #perform}. */
    public SmppServer smpp() {
        return smpp;
    }

    /** Has something done at this moment. */
    public void perform(long nowNanos, Runnable action) {
        advanceTimers(nowNanos);
        action.run();
        settle();
    }

    /** The store has made an entry durable, or has failed to. */
    public void committed(long nowNanos, long ticket, boolean isDurable) {
        advanceTimers(nowNanos);
        try {
            shortMessages.committed(ticket, isDurable);
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "an error of our own after a commit", e);
        }
        settle();
    }

    /** Time has passed. */
    public void advance(long nowNanos) {
        advanceTimers(nowNanos);
        settle();
    }

    /** When {@link #advance} must be called at the latest. */
    public OptionalLong nextDeadlineNanos() {
        return timers.nextDeadlineNanos();
    }

    private void receive(Link link, IpaFrame frame) throws ProtocolViolation {
        switch (frame.stream()) {
            case IpaFrame.SPEECH -> receiveSpeech(link, frame);
            case IpaFrame.RSL -> signalling.receive(link, RslCodec.decode(frame.payload()));
            case IpaFrame.CCM -> link.receive(CcmCodec.decode(frame.payload()));
            default -> link.violated("sent a frame of unknown stream " + frame.stream());
        }
    }

    private void receiveSpeech(Link link, IpaFrame frame) {
        if (CallSwitch.isRtp(frame.payload())) {
            calls.switchSpeech(link, frame);
        } else {
            link.violated("sent speech that is no RTP packet of version 2");
        }
    }

    /**
     * Lets held calls go on and releases the channels that nothing needs any more; only links on which something happened
     * are looked at.
     */
    private void settle() {
        while (!settlement.isEmpty()) {
            calls.legsChanged();
            List<Link> touched = new ArrayList<>(settlement);
            settlement.clear();
            for (Link link : touched) {
                settle(link);
            }
        }
    }

    private static void settle(Link link) {
        try {
            if (!link.isClosed) {
                link.radio.releaseIfUnused();
            }
        } catch (RuntimeException e) {
            link.failed(e);
        }
    }

    /**
     * Moves the time forward. An error of our own in a timer of a link or application ends that one; in any other timer it
     * is logged. In no case does it reach the caller, whose frame belongs to another link.
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
     * Sends a text to everybody who is attached, now and perhaps again.
     *
     * @throws IllegalArgumentException saying what is wrong with the order
     */
    public BroadcastView broadcast(long nowNanos, BroadcastOrder order) {
        advanceTimers(nowNanos);
        return broadcaster.broadcast(order);
    }

    /** @return false if no broadcast with this id is repeated */
    public boolean stopBroadcast(int id) {
        return broadcaster.stop(id);
    }

    /** Broadcasts that are repeated, oldest first. */
    public List<BroadcastView> broadcasts() {
        return broadcaster.running();
    }

    // What an operator looks at; all of it on the driving thread.

    public Collection<Subscriber> subscribers() {
        return register.all();
    }

    /** Whether the operator lets the subscriber not register. */
    public boolean isBarred(Subscriber subscriber) {
        return register.home().isBarred(subscriber.imsi());
    }

    /** Whether this number has ever registered, or is listed. */
    public boolean isKnown(Msisdn number) {
        return register.ofNumber(number).isPresent();
    }

    /** Calls under way, oldest first. */
    public List<CallView> calls() {
        return calls.calls().stream().map(CallView::of).toList();
    }

    public ShortMessageCenter shortMessages() {
        return shortMessages;
    }

    public int linkCount() {
        return links.size();
    }

    /** An immutable picture of everything for a window; its size is bounded. */
    public ExchangeSnapshot snapshot() {
        return snapshots.make(startedAt.plusNanos(timers.nowNanos()), links.size());
    }
}
