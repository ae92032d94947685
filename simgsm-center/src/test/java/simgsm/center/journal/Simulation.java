package simgsm.center.journal;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import simgsm.abis.IpaFrame;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.subscriber.HomeRegister;
import simgsm.octets.OctetString;
import simgsm.sim.Milenage;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;
import simgsm.station.mobility.Sim;

/**
 * Exchange core, journal, disk, phones and an application under one clock and one seed: phones call, text, fill up, vanish
 * and come back, the application submits, refuses and leaves, the disk fails, the centre dies at any step and starts again
 * from its journal. Whatever happens: no acknowledged message is lost; none is shown twice; none whose delivery is on the
 * disk is sent again; one that is sent again is the same, octet for octet; a receipt says the same each time; a broadcast is
 * shown once; no number is held twice; no call is stuck; no timer is forgotten. Every other seed is a closed network in
 * which every phone has its card: none is ever refused.
 */
final class Simulation {
    /** Texts that begin so are written once. */
    static final String UNIQUE = "text ";

    private static final long MILLI = 1_000_000;
    private static final int STEPS = 1_200;
    private static final int PHONES = 4;
    /** Longer than the pause after which a store that failed is asked again. */
    private static final int LEAST_ROUNDS_TO_REST = 40;

    /** Longer than any of the network's short timers, in total. */
    private static final int MOST_ROUNDS_TO_REST = 600;
    /** Shorter than T3113, so that a paged mobile can answer in time. */
    private static final long LONGEST_STEP_MILLIS = 2_000;

    private final SplittableRandom random;
    private final Act.Choice acts;
    private final Account account = new Account();
    private final SimulatedCenter center;
    private final List<SimulatedPhone> phones = new ArrayList<>();
    private final SimulatedApplication application;
    /** Connections that are gone on the phone's side and not yet on the centre's. */
    private final List<SimulatedPhone.Wire> unnoticed = new ArrayList<>();

    private long nowNanos = 1_000_000_000_000L;
    private int texts;
    private int broadcasts;
    private int callsSetUp;
    private long trace = 1;

    Simulation(long seed) {
        random = new SplittableRandom(seed);
        acts = Act.choice(random);
        List<SimCard> cards = cards();
        boolean isClosed = seed % 2 != 0;
        center = new SimulatedCenter(random.split(), account, isClosed ? closedTo(cards) : HomeRegister.OPEN, nowNanos);
        for (SimCard card : cards) {
            phones.add(new SimulatedPhone(card, isClosed ? Sim.of(card) : Sim.WITHOUT_KEY, random.split(), account));
        }
        application = new SimulatedApplication(random.split(), account);
    }

    private List<SimCard> cards() {
        List<SimCard> cards = new ArrayList<>();
        for (int i = 0; i < PHONES; i++) {
            Msisdn number = new Msisdn("555010" + i);
            cards.add(new SimCard(Imsi.ofOpenNumber(number), number, key(), key()));
        }
        return cards;
    }

    private OctetString key() {
        byte[] octets = new byte[Milenage.KEY_LENGTH];
        random.nextBytes(octets);
        return OctetString.of(octets);
    }

    private static HomeRegister closedTo(List<SimCard> cards) {
        return HomeRegister.closed(
                cards.stream().map(card -> new Subscription(card, false)).toList(), List.of());
    }

    int acknowledgedCount() {
        return account.acknowledgedCount();
    }

    int deaths() {
        return center.deaths;
    }

    int callsSetUp() {
        return callsSetUp;
    }

    /** Another for every course that things may take; the same seed takes the same. */
    long trace() {
        return trace;
    }

    void run() throws IOException {
        center.live();
        for (int step = 0; step < STEPS; step++) {
            try {
                step(acts.next(random));
            } catch (SimulatedDisk.MachineDied death) {
                die();
            }
        }
        comeToRest();
    }

    private void step(Act act) throws IOException {
        trace = trace * 31 + act.ordinal() + account.shownCount() * 7L;
        SimulatedPhone phone = phones.get(random.nextInt(PHONES));
        Invariant.tell(() -> nowNanos / MILLI + " ms: " + act + " " + phone.number);
        switch (act) {
            case CARRY -> carry(phone, random.nextBoolean(), 1 + random.nextInt(8));
            case SERVE_ALL -> serveAll(2);
            case COMMIT -> center.commit();
            case ANSWER -> center.answer();
            case PASS_MILLIS -> pass(random.nextLong(700));
            case PASS_A_MINUTE -> pass(random.nextLong(60_000));
            case PASS_MANY_MINUTES -> pass(random.nextLong(40 * 60_000));
            case CONNECT -> connect(phone);
            case WRITE -> write(phone);
            case DIAL -> phone.station.dial(phones.get(random.nextInt(PHONES)).number);
            case PICK_UP -> callsSetUp += phone.station.answer() ? 1 : 0;
            case HANG_UP -> phone.station.hangUp();
            case SWITCH_ON -> phone.station.powerOn();
            case SWITCH_OFF -> phone.station.powerOff();
            case VANISH -> vanish(phone);
            case VANISH_UNNOTICED -> vanishUnnoticed(phone);
            case NOTICE -> noticeOne();
            case MEMORY_FULL -> phone.station.setMemoryAvailable(false);
            case MEMORY_FREE -> phone.station.setMemoryAvailable(true);
            case BROADCAST -> broadcast();
            case APPLICATION_BINDS -> application.bind(center.exchange(), center.smpp(), center.ownNanos());
            case APPLICATION_SUBMITS -> application.submit(phone.number.digits(), UNIQUE + texts++);
            case APPLICATION_ANSWERS -> application.answer(false);
            case APPLICATION_LEAVES -> application.leave(center.exchange(), center.ownNanos());
            case DISK_FAILS -> center.disk.failureRate = random.nextBoolean() ? 0.3 : 1;
            case DISK_RECOVERS -> center.disk.failureRate = 0;
            case POWER_CUT -> center.disk.dieAfter(random.nextInt(20));
            case KILL_IN_DISK -> center.disk.killAfter(random.nextInt(20));
            case KILL -> {
                center.disk.killAfter(0);
                die();
            }
        }
        dropBroken();
    }

    /** Some texts are long, and some alike. An application would see the parts of a long one. */
    private void write(SimulatedPhone phone) {
        int index = random.nextInt(PHONES + 1);
        boolean isToApplication = index == PHONES;
        Msisdn to = isToApplication ? new Msisdn(SimulatedApplication.NUMBER) : phones.get(index).number;
        switch (random.nextInt(16)) {
            case 0 -> phone.write(to, "long " + texts++ + "x".repeat(isToApplication ? 0 : 300));
            case 1, 2 -> phone.write(to, "ping");
            default -> phone.write(to, UNIQUE + texts++);
        }
    }

    private void broadcast() {
        BroadcastOrder order = new BroadcastOrder(
                random.nextInt(3),
                "news " + broadcasts++,
                Optional.empty(),
                Duration.ofSeconds(1 + random.nextInt(60)),
                OptionalInt.of(1 + random.nextInt(4)),
                OptionalInt.empty());
        center.exchange().broadcast(center.ownNanos(), order);
    }

    private void die() throws IOException {
        for (SimulatedPhone phone : phones) {
            if (phone.isConnected()) {
                phone.disconnected(nowNanos);
            }
        }
        unnoticed.clear();
        application.disconnected();
        center.die();
    }

    private void pass(long millis) {
        nowNanos += millis * MILLI;
        center.pass(nowNanos);
        phones.forEach(phone -> phone.station.timePassed(nowNanos));
    }

    // Connections.

    private void connect(SimulatedPhone phone) {
        if (!phone.isConnected()) {
            SimulatedPhone.Wire wire = new SimulatedPhone.Wire(center.watch());
            phone.wire = wire;
            wire.link = center.exchange().linkOpened(center.ownNanos(), wire.downlink(), phone.number.digits());
            phone.station.linkUp(wire, nowNanos);
        }
    }

    private void vanish(SimulatedPhone phone) {
        if (phone.isConnected()) {
            SimulatedPhone.Wire gone = phone.wire;
            phone.disconnected(nowNanos);
            closed(gone);
        }
    }

    private void closed(SimulatedPhone.Wire wire) {
        center.exchange().linkClosed(center.ownNanos(), wire.link, "vanished");
    }

    /** What was on its way up may still arrive; what goes down is lost. */
    private void vanishUnnoticed(SimulatedPhone phone) {
        if (phone.isConnected()) {
            unnoticed.add(phone.wire);
            phone.disconnected(nowNanos);
        }
    }

    private void noticeOne() {
        if (!unnoticed.isEmpty()) {
            SimulatedPhone.Wire wire = unnoticed.remove(random.nextInt(unnoticed.size()));
            for (int i = random.nextInt(wire.up.size() + 1); i > 0 && !wire.isDropped; i--) {
                center.receive(wire.link, wire.up.remove());
            }
            closed(wire);
        }
    }

    private void dropBroken() {
        for (SimulatedPhone phone : phones) {
            if (phone.isConnected() && phone.wire.isDropped) {
                vanish(phone);
            }
        }
        if (application.isDropped()) {
            application.leave(center.exchange(), center.ownNanos());
        }
    }

    /** Some frames of one phone arrive, in one direction. */
    private void carry(SimulatedPhone phone, boolean isUp, int most) {
        for (int i = 0; i < most && phone.isConnected(); i++) {
            SimulatedPhone.Wire wire = phone.wire;
            IpaFrame frame = (isUp ? wire.up : wire.down).poll();
            if (frame == null) {
                return;
            }
            Invariant.tell(() ->
                    phone.number + (isUp ? " up " : " down ") + HexFormat.of().formatHex(frame.payload()));
            if (isUp) {
                center.receive(wire.link, frame);
            } else {
                phone.station.frameArrived(frame, nowNanos);
            }
            dropBroken();
        }
    }

    /** Everything that can travel travels, and the disk does all it is asked; in a bounded number of rounds. */
    private void serveAll(int rounds) {
        boolean isBusy = true;
        for (int i = 0; i < rounds && isBusy; i++) {
            isBusy = center.serveAll() | application.carry(center.exchange(), center.ownNanos());
            for (SimulatedPhone phone : phones) {
                if (phone.isConnected() && !phone.wire.isIdle()) {
                    isBusy = true;
                    carry(phone, true, Integer.MAX_VALUE);
                    carry(phone, false, Integer.MAX_VALUE);
                }
            }
        }
    }

    // The end.

    /** All that hindered is over; in ever longer steps, but shorter than any timer, everything finds its end. */
    private void comeToRest() throws IOException {
        center.disk.failureRate = 0;
        center.disk.dieAfter(Integer.MAX_VALUE);
        while (!unnoticed.isEmpty()) {
            noticeOne();
        }
        center.exchange().broadcasts().forEach(each -> center.exchange().stopBroadcast(each.id()));
        // A receiver that has refused for long is tried again after hours, or when it registers anew.
        application.leave(center.exchange(), center.ownNanos());
        long stepMillis = 100;
        for (int i = 0; i < MOST_ROUNDS_TO_REST; i++) {
            phones.forEach(this::bringBack);
            application.bind(center.exchange(), center.smpp(), center.ownNanos());
            while (application.hasUnanswered()) {
                application.answer(true);
            }
            serveAll(Integer.MAX_VALUE);
            if (i > LEAST_ROUNDS_TO_REST && center.isAtRest() && allAreRegistered()) {
                break;
            }
            pass(stepMillis);
            dropBroken();
            stepMillis = Math.min(LONGEST_STEP_MILLIS, stepMillis * 21 / 20);
            if (i == MOST_ROUNDS_TO_REST / 2) {
                // What waits by the schedule, for hours perhaps, is tried when its receiver comes anew.
                phones.forEach(this::vanish);
            }
        }
        checkRest();
    }

    private void bringBack(SimulatedPhone phone) {
        connect(phone);
        phone.station.powerOn();
        phone.station.hangUp();
        phone.station.setMemoryAvailable(true);
    }

    private boolean allAreRegistered() {
        return phones.stream().allMatch(phone -> phone.station.snapshot().registered());
    }

    private void checkRest() throws IOException {
        Invariant.holds(
                center.exchange().calls().isEmpty(),
                () -> "a call is stuck: " + center.exchange().calls());
        Invariant.holds(
                center.isAtRest(),
                () -> center.exchange().shortMessages().waitingCount() + " wait for ever: "
                        + center.exchange().shortMessages().messages().waitingHistories(3));
        Invariant.holds(allAreRegistered(), () -> "a phone cannot come back");
        account.close();
        phones.forEach(this::vanish);
        application.leave(center.exchange(), center.ownNanos());
        serveAll(Integer.MAX_VALUE);
        center.checkEmpty();
    }
}
