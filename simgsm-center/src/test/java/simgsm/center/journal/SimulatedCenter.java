package simgsm.center.journal;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.link.Peer;
import simgsm.center.smpp.SmppServer;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.subscriber.HomeRegister;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.TpduCodec;

/**
 * Exchange core, journal and disk through many lives. What was made durable is compared with what each life begins with,
 * and what is delivered with what was delivered before.
 */
final class SimulatedCenter {
    private static final Instant START = Instant.parse("2026-11-21T12:00:00Z");
    /** Small, so that every seed sees compactions, of several segments. */
    private static final Journal.Limits LIMITS = new Journal.Limits(1_500, 2_000, 1, 4, 200);

    private static final int RESERVE_OCTETS = 1_000;

    /** TP-MMS may change from one attempt to the next. */
    private static final int MORE_MESSAGES = 0x04;

    private record Order(long ticket, List<StoreEntry> entries) {}

    private record Answer(List<Long> tickets, boolean isDurable) {}

    final SimulatedDisk disk;
    private final SplittableRandom random;
    private final Account account;
    /** Ids on the disk as accepted; ids on the disk as ended; ids that were ended, on the disk or not. */
    private final Set<Long> durable = new HashSet<>();

    private final Set<Long> durablyEnded = new HashSet<>();
    private final Set<Long> ended = new HashSet<>();
    private final Map<Long, Account.Key> keys = new HashMap<>();
    private final Map<String, Long> idOfText = new HashMap<>();
    private final Map<String, OctetString> octetsOfText = new HashMap<>();
    private final HomeRegister home;
    private final Set<Msisdn> attached = new HashSet<>();
    /** By the frame that arrives now. */
    private final Set<Msisdn> attachedNow = new HashSet<>();

    private final Deque<Order> orders = new ArrayDeque<>();
    private final Deque<Answer> answers = new ArrayDeque<>();
    private long bornNanos;
    private long nowNanos;
    private Exchange exchange;
    private SmppServer smpp;
    private Journal journal;
    int deaths;

    SimulatedCenter(SplittableRandom random, Account account, HomeRegister home, long nowNanos) {
        this.random = random;
        this.home = home;
        this.account = account;
        this.nowNanos = nowNanos;
        disk = new SimulatedDisk(random.split());
    }

    Exchange exchange() {
        return exchange;
    }

    SmppServer smpp() {
        return smpp;
    }

    /** As the present life of the exchange counts it. */
    long ownNanos() {
        return nowNanos - bornNanos;
    }

    void pass(long toNanos) {
        nowNanos = toNanos;
        exchange.advance(ownNanos());
        long deadline = exchange.nextDeadlineNanos().orElse(Long.MAX_VALUE);
        Invariant.holds(deadline > ownNanos(), () -> "what was due at " + deadline + " is not done");
    }

    // Lives and deaths.

    void live() throws IOException {
        while (true) {
            try {
                journal = Journal.open(disk, LIMITS);
                journal.holdReserve(RESERVE_OCTETS);
                break;
            } catch (SimulatedDisk.MachineDied death) {
                disk.comeBack();
            } catch (IOException failure) {
                // A centre does not start on a disk that fails; the disk is repaired and the centre starts again.
                disk.failureRate = 0;
            }
        }
        checkRestored();
        bornNanos = nowNanos;
        smpp = new SmppServer();
        exchange = new Exchange(
                new ExchangeSettings("SimGSM", random.split(), START.plusNanos(nowNanos), home, Optional.empty()),
                this::order,
                smpp.routes(),
                this::happened);
        smpp.serve(exchange.shortMessages(), exchange.timers());
        exchange.restore(journal.stored());
    }

    /** Dies as the disk was told; the next life may die while it reads the journal. */
    void die() throws IOException {
        deaths++;
        orders.clear();
        answers.clear();
        attached.clear();
        disk.comeBack();
        switch (random.nextInt(6)) {
            case 0 -> disk.dieAfter(random.nextInt(20));
            case 1 -> disk.killAfter(random.nextInt(20));
            default -> {
                // Lives on.
            }
        }
        live();
    }

    private void checkRestored() {
        Set<Long> waiting = new HashSet<>();
        journal.stored().waiting().stream().map(ShortMessage::id).forEach(waiting::add);
        for (long id : durable) {
            Invariant.holds(waiting.contains(id) || ended.contains(id), () -> "message " + id + " is lost");
        }
        for (long id : durablyEnded) {
            Invariant.holds(!waiting.contains(id), () -> "message " + id + " has ended and comes back");
        }
    }

    // What the exchange says.

    private void happened(ExchangeEvent event) {
        if (event instanceof ExchangeEvent.Attached there) {
            Invariant.holds(attached.add(there.number()), () -> there.number() + " is held twice");
            attachedNow.add(there.number());
        } else if (event instanceof ExchangeEvent.Detached gone) {
            Invariant.holds(attached.remove(gone.number()), () -> gone.number() + " was not there");
        }
    }

    private void order(long ticket, List<StoreEntry> entries) {
        entries.forEach(this::note);
        orders.add(new Order(ticket, entries));
    }

    private void note(StoreEntry entry) {
        if (entry instanceof StoreEntry.Accepted accepted) {
            accepted(accepted.message());
        } else if (entry instanceof StoreEntry.Ended end) {
            ended.add(end.id());
            if (end.state() != MessageState.DELIVERED) {
                account.givenUp(keys.get(end.id()), end.id());
            }
        }
        Invariant.tell(() -> "to be stored: " + entry);
    }

    private void accepted(ShortMessage message) {
        Account.Key key = new Account.Key(message.sender().value(), message.to().digits(), message.text());
        keys.put(message.id(), key);
        idOfText.put(key.text(), message.id());
    }

    /** Watches the frames that go down on one connection. */
    Consumer<IpaFrame> watch() {
        ReleaseWatch releases = new ReleaseWatch();
        return frame -> watch(frame, releases);
    }

    private void watch(IpaFrame frame, ReleaseWatch releases) {
        if (frame.stream() != IpaFrame.RSL) {
            return;
        }
        try {
            if (RslMessage.decode(frame.payload()) instanceof RslMessage.DataRequest request) {
                watch(Layer3Codec.decode(request.layer3().toArray(), Direction.DOWNLINK), releases);
            }
        } catch (ProtocolViolation violation) {
            throw new AssertionError("the exchange sends " + violation.getMessage(), violation);
        }
    }

    /** A short message that goes down must not have ended on the disk, and must be the same octets as before. */
    private void watch(Layer3Message message, ReleaseWatch releases) throws ProtocolViolation {
        if (message instanceof CallControl call) {
            releases.sent(call);
        } else if (message instanceof CpData data
                && data.relay() instanceof RpData relayed
                && TpduCodec.decode(relayed.tpdu(), Direction.DOWNLINK) instanceof DeliverTpdu deliver) {
            watch(deliver.userData().text(), relayed.tpdu());
        }
    }

    private void watch(String text, OctetString tpdu) {
        if (!text.startsWith(Simulation.UNIQUE)) {
            return;
        }
        long id = idOfText.get(text);
        Invariant.tell(() -> "message " + id + " goes down: " + text + ", " + tpdu);
        Invariant.holds(!durablyEnded.contains(id), () -> "message " + id + " has ended and is sent again");
        byte[] octets = tpdu.toArray();
        octets[0] |= MORE_MESSAGES;
        OctetString now = OctetString.of(octets);
        OctetString before = octetsOfText.putIfAbsent(text, now);
        Invariant.holds(before == null || before.equals(now), () -> "message " + id + " comes again changed");
    }

    /** A frame arrives. A receiver that registers by it is tried at once: none of its messages waits for its schedule. */
    void receive(Peer link, IpaFrame frame) {
        attachedNow.clear();
        exchange.frameReceived(ownNanos(), link, frame);
        if (attachedNow.isEmpty()) {
            return;
        }
        for (MessageHistory each : exchange.shortMessages().messages().waitingHistories(Integer.MAX_VALUE)) {
            Invariant.holds(
                    !attachedNow.contains(each.message().to()) || each.nextTry().isEmpty(),
                    () -> "message " + each.message().id() + " waits for its schedule though its receiver is there");
        }
    }

    // The disk's work.

    void commit() {
        List<Order> group = new ArrayList<>();
        int count = 1 + random.nextInt(5);
        while (!orders.isEmpty() && group.size() < count) {
            group.add(orders.remove());
        }
        boolean isDurable = journal.commit(
                group.stream().flatMap(order -> order.entries().stream()).toList());
        Invariant.tell(() -> (isDurable ? "stored: " : "not stored: ") + group);
        for (Order order : group) {
            order.entries().forEach(entry -> note(entry, isDurable));
        }
        answers.add(new Answer(group.stream().map(Order::ticket).toList(), isDurable));
        journal.compact();
    }

    private void note(StoreEntry entry, boolean isDurable) {
        if (isDurable && entry instanceof StoreEntry.Accepted accepted) {
            durable.add(accepted.message().id());
        } else if (isDurable && entry instanceof StoreEntry.Ended end) {
            durablyEnded.add(end.id());
        }
    }

    void answer() {
        Answer answer = answers.poll();
        if (answer != null) {
            answer.tickets().forEach(ticket -> exchange.committed(ownNanos(), ticket, answer.isDurable()));
        }
    }

    /** The disk does all it is asked. @return whether it was asked anything */
    boolean serveAll() {
        boolean wasBusy = !orders.isEmpty() || !answers.isEmpty();
        while (!orders.isEmpty()) {
            commit();
        }
        while (!answers.isEmpty()) {
            answer();
        }
        if (journal.isFailing()) {
            // As the journal's thread does from time to time, so that what is owed does not wait for the next message.
            journal.commit(List.of());
        }
        return wasBusy;
    }

    boolean isAtRest() {
        return exchange.shortMessages().waitingCount() == 0 && exchange.calls().isEmpty();
    }

    /** No terminal is connected, and no work is pending. */
    void checkEmpty() throws IOException {
        Invariant.holds(exchange.linkCount() == 0, () -> exchange.linkCount() + " links are left");
        Invariant.holds(smpp.boundSessions() == 0, () -> "an application is left");
        Invariant.holds(attached.isEmpty(), () -> attached + " are attached without a link");
        Invariant.holds(exchange.nextDeadlineNanos().isEmpty(), () -> "a timer is forgotten");
        Invariant.holds(
                Journal.open(disk, LIMITS).stored().waiting().isEmpty(), () -> "the journal still holds a message");
    }
}
