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
import java.util.Set;
import java.util.SplittableRandom;
import simgsm.air.IpaFrame;
import simgsm.air.Msisdn;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;

/**
 * Exchange core, journal, disk and phones under one clock and one seed: phones call, text, vanish and come back, the disk
 * fails, the centre dies at any step and starts again from its journal. Whatever happens: no acknowledged message is
 * lost, none is shown twice, none whose delivery is on the disk comes back, no call is stuck, no timer forgotten.
 */
final class Simulation {
    private static final Instant START = Instant.parse("2026-11-21T12:00:00Z");
    private static final long MILLI = 1_000_000;
    private static final int STEPS = 1_500;
    private static final int PHONES = 4;

    private record Order(long ticket, StoreEntry entry) {}

    private record Answer(List<Long> tickets, boolean isDurable) {}

    private final SplittableRandom random;
    private final SimulatedDisk disk;
    private final List<SimulatedPhone> phones = new ArrayList<>();
    private final Map<String, Integer> shown = new HashMap<>();
    private final Set<String> acknowledged = new HashSet<>();
    /** Ids on the disk as accepted; ids on the disk as ended; ids that were ended, on the disk or not. */
    private final Set<Long> durable = new HashSet<>();

    private final Set<Long> durablyEnded = new HashSet<>();
    private final Set<Long> ended = new HashSet<>();

    private final Deque<Order> orders = new ArrayDeque<>();
    private final Deque<Answer> answers = new ArrayDeque<>();
    private long nowNanos = 1_000_000_000_000L;
    private long bornNanos;
    private Exchange exchange;
    private Journal journal;
    private int texts;
    int deaths;

    Simulation(long seed) {
        random = new SplittableRandom(seed);
        disk = new SimulatedDisk(random.split());
        for (int i = 0; i < PHONES; i++) {
            phones.add(new SimulatedPhone("555010" + i, random.split(), shown, acknowledged));
        }
    }

    /** How many messages were acknowledged to their senders. */
    int acknowledgedCount() {
        return acknowledged.size();
    }

    void run() throws IOException {
        live();
        for (int step = 0; step < STEPS; step++) {
            try {
                step();
            } catch (SimulatedDisk.MachineDied death) {
                die();
            }
            check(shown.values().stream().allMatch(times -> times == 1), "shown twice: " + shown);
        }
        comeToRest();
    }

    private static void check(boolean holds, String otherwise) {
        if (!holds) {
            throw new AssertionError(otherwise);
        }
    }

    // The centre's lives.

    private void live() throws IOException {
        while (true) {
            try {
                journal = Journal.open(disk, 2_000, 50);
                break;
            } catch (SimulatedDisk.MachineDied death) {
                disk.crash();
            }
        }
        checkRestored();
        bornNanos = nowNanos;
        exchange = new Exchange(
                new ExchangeSettings("SimGSM", random.nextLong(), START.plusNanos(nowNanos)), this::order, event -> {});
        exchange.restore(journal.restored());
    }

    private void order(long ticket, StoreEntry entry) {
        if (entry instanceof StoreEntry.Ended end) {
            ended.add(end.id());
        }
        orders.add(new Order(ticket, entry));
    }

    private void checkRestored() {
        Set<Long> waiting = new HashSet<>();
        journal.restored().waiting().stream().map(ShortMessage::id).forEach(waiting::add);
        for (long id : durable) {
            check(waiting.contains(id) || ended.contains(id), "message " + id + " is lost");
        }
        for (long id : durablyEnded) {
            check(!waiting.contains(id), "message " + id + " has ended and comes back");
        }
    }

    private void die() throws IOException {
        deaths++;
        orders.clear();
        answers.clear();
        for (SimulatedPhone phone : phones) {
            if (phone.isConnected()) {
                phone.disconnected(nowNanos);
            }
        }
        disk.crash();
        live();
    }

    // What may happen next.

    private void step() throws IOException {
        SimulatedPhone phone = phones.get(random.nextInt(PHONES));
        switch (random.nextInt(40)) {
            case 0 -> pass(random.nextLong(60_000));
            case 1, 2, 3 -> pass(random.nextLong(500));
            case 4, 5, 6, 7 -> commit();
            case 8, 9, 10, 11 -> answer();
            case 12, 13, 14 -> phone.write(other(), "text " + texts++ + "x".repeat(random.nextInt(20) == 0 ? 300 : 0));
            case 15 -> phone.station.dial(other());
            case 16 -> phone.station.answer();
            case 17 -> phone.station.hangUp();
            case 18 -> power(phone);
            case 19 -> vanish(phone);
            case 20 -> mishap();
            case 21, 22 -> connect(phone);
            default -> carry(phone);
        }
        dropBroken();
    }

    private Msisdn other() {
        return phones.get(random.nextInt(PHONES)).number;
    }

    private void power(SimulatedPhone phone) {
        if (phone.station.snapshot().powered()) {
            phone.station.powerOff();
        } else {
            phone.station.powerOn();
        }
    }

    private void mishap() throws IOException {
        switch (random.nextInt(4)) {
            case 0 -> disk.failureRate = random.nextBoolean() ? 0.3 : 1;
            case 1 -> disk.dieAfter(random.nextInt(12));
            case 2 -> {
                if (random.nextInt(3) == 0) {
                    die();
                }
            }
            default -> disk.failureRate = 0;
        }
    }

    private void pass(long millis) {
        nowNanos += millis * MILLI;
        exchange.advance(nowNanos - bornNanos);
        phones.forEach(phone -> phone.station.timePassed(nowNanos));
    }

    private void commit() {
        List<Order> group = new ArrayList<>();
        int count = 1 + random.nextInt(5);
        while (!orders.isEmpty() && group.size() < count) {
            group.add(orders.remove());
        }
        boolean isDurable = journal.commit(group.stream().map(Order::entry).toList());
        for (Order order : group) {
            note(order.entry(), isDurable);
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

    private void answer() {
        Answer answer = answers.poll();
        if (answer != null) {
            answer.tickets().forEach(ticket -> exchange.committed(nowNanos - bornNanos, ticket, answer.isDurable()));
        }
    }

    private void connect(SimulatedPhone phone) {
        if (!phone.isConnected()) {
            phone.link = exchange.linkOpened(nowNanos - bornNanos, phone.downlink(), phone.number.digits());
            phone.station.linkUp(phone.uplink(), nowNanos);
        }
    }

    /** Sometimes the centre notices later than the phone, when the phone is back on a new connection. */
    private void vanish(SimulatedPhone phone) {
        if (phone.isConnected()) {
            exchange.linkClosed(nowNanos - bornNanos, phone.link, "vanished");
            phone.disconnected(nowNanos);
        }
    }

    private void dropBroken() {
        for (SimulatedPhone phone : phones) {
            if (phone.isDropped) {
                vanish(phone);
            }
        }
    }

    /** Some frames of one phone arrive, in one direction. */
    private void carry(SimulatedPhone phone) {
        boolean isUp = random.nextBoolean();
        for (int i = random.nextInt(6); i >= 0 && phone.isConnected(); i--) {
            IpaFrame frame = (isUp ? phone.up : phone.down).poll();
            if (frame == null) {
                return;
            }
            if (isUp) {
                exchange.frameReceived(nowNanos - bornNanos, phone.link, frame);
            } else {
                phone.station.frameArrived(frame, nowNanos);
            }
            dropBroken();
        }
    }

    // The end.

    private void comeToRest() throws IOException {
        disk.failureRate = 0;
        disk.dieAfter(Integer.MAX_VALUE);
        phones.forEach(phone -> {
            phone.station.powerOn();
            phone.station.hangUp();
        });
        // Longer than the retry schedule's pauses can have grown; in ever longer steps, but shorter than any timer.
        long stepMillis = 100;
        for (int i = 0; i < 400; i++) {
            phones.forEach(this::connect);
            serveAll();
            pass(stepMillis);
            stepMillis = Math.min(20_000, stepMillis * 21 / 20);
            phones.forEach(phone -> phone.station.hangUp());
        }
        serveAll();
        check(exchange.calls().isEmpty(), "a call is stuck: " + exchange.calls());
        check(
                exchange.shortMessages().waitingCount() == 0,
                exchange.shortMessages().waitingCount() + " wait for ever ");
        for (String text : acknowledged) {
            check(
                    shown.getOrDefault(text, 0) == 1,
                    "\"" + text + "\" was acknowledged and shown " + shown.getOrDefault(text, 0) + " times");
        }
        check(shown.values().stream().allMatch(times -> times == 1), "shown twice: " + shown);
        phones.forEach(this::vanish);
        serveAll();
        check(exchange.linkCount() == 0, "a link is left");
        check(exchange.nextDeadlineNanos().isEmpty(), "a timer is forgotten");
        check(Journal.open(disk, 2_000, 50).restored().waiting().isEmpty(), "the journal still holds a message");
    }

    /** Everything that can travel travels, and the disk does all it is asked. */
    private void serveAll() {
        boolean isBusy = true;
        while (isBusy) {
            isBusy = !orders.isEmpty() || !answers.isEmpty();
            while (!orders.isEmpty()) {
                commit();
            }
            while (!answers.isEmpty()) {
                answer();
            }
            for (SimulatedPhone phone : phones) {
                while (!phone.up.isEmpty() || !phone.down.isEmpty()) {
                    isBusy = true;
                    carry(phone);
                }
            }
        }
    }
}
