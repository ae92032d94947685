package simgsm.center.msc;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import simgsm.abis.MediaPort;
import simgsm.air.CallControl;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.subscriber.HomeRegister;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;
import simgsm.tone.ToneSet;

/** An exchange with a clock moved by hand and a store that commits when told to. */
final class TestNetwork {
    static final Instant START = Instant.parse("2026-11-21T12:00:00Z");

    private static final long MAX_STEP_NANOS = Duration.ofSeconds(20).toNanos();

    private final Map<String, MediaPort> media = new HashMap<>();
    private final List<TestMobile> mobiles = new ArrayList<>();
    private final SplittableRandom equipment = new SplittableRandom(1);
    final List<ExchangeEvent> events = new ArrayList<>();
    /** What was stored of messages. */
    final List<StoreEntry> stored = new ArrayList<>();

    private final Deque<Long> uncommitted = new ArrayDeque<>();
    boolean commitsAtOnce = true;
    long nowNanos;
    final Exchange exchange;
    /** Whose registration is challenged. */
    List<SimCard> cards = List.of();

    TestNetwork() {
        this(HomeRegister.OPEN);
    }

    TestNetwork(HomeRegister home) {
        this(home, Optional.empty());
    }

    /** A network closed to these cards. */
    TestNetwork(List<SimCard> cards) {
        this(
                HomeRegister.closed(
                        cards.stream()
                                .map(card -> new Subscription(card, false))
                                .toList(),
                        List.of()),
                Optional.empty());
        this.cards = cards;
    }

    TestNetwork(HomeRegister home, Optional<ToneSet> tones) {
        this(new ExchangeSettings("SimGSM", new SplittableRandom(1), START, home, tones));
    }

    TestNetwork(ExchangeSettings settings) {
        exchange = new Exchange(settings, this::store, events::add);
    }

    /** Gives the terminal that will connect with this number a socket for speech over UDP. */
    void mediaOf(String number, MediaPort port) {
        media.put(number, port);
    }

    MediaPort mediaOf(String number) {
        return media.getOrDefault(number, new MediaPort() {});
    }

    /** The terminal that connected with this number. */
    TestMobile mobile(String number) {
        Imsi imsi = Imsi.ofOpenNumber(new Msisdn(number));
        return mobiles.stream()
                .filter(mobile -> mobile.imsi.equals(imsi))
                .findFirst()
                .orElseThrow();
    }

    private void store(long ticket, List<StoreEntry> entries) {
        entries.stream().filter(entry -> !(entry instanceof StoreEntry.Known)).forEach(stored::add);
        uncommitted.add(ticket);
    }

    /** A terminal that has connected and not yet spoken. */
    TestMobile connect(String number) {
        return connect(number, Imei.random(equipment));
    }

    TestMobile connect(String number, Imei imei) {
        TestMobile mobile = new TestMobile(this, number, imei);
        mobiles.add(mobile);
        return mobile;
    }

    TestMobile attach(String number) {
        return connect(number).register();
    }

    /** Time passes; pings are answered on the way. */
    void pass(Duration time) {
        long end = nowNanos + time.toNanos();
        while (nowNanos < end) {
            nowNanos = Math.min(end, nowNanos + MAX_STEP_NANOS);
            exchange.advance(nowNanos);
            commitIfAtOnce();
            mobiles.forEach(TestMobile::answerPings);
        }
    }

    /** Time passes in one step; no mobile answers meanwhile. */
    void leap(Duration time) {
        nowNanos += time.toNanos();
        exchange.advance(nowNanos);
        commitIfAtOnce();
    }

    void everybodyVanishes() {
        mobiles.forEach(TestMobile::vanish);
    }

    void passSeconds(long seconds) {
        pass(Duration.ofSeconds(seconds));
    }

    void commitAll(boolean isDurable) {
        for (Long ticket = uncommitted.poll(); ticket != null; ticket = uncommitted.poll()) {
            exchange.committed(nowNanos, ticket, isDurable);
        }
    }

    void commitIfAtOnce() {
        if (commitsAtOnce) {
            commitAll(true);
        }
    }

    /** The states that the calls have gone through, as events. */
    List<CallProgress> callStates() {
        return events.stream()
                .filter(ExchangeEvent.CallChanged.class::isInstance)
                .map(event -> ((ExchangeEvent.CallChanged) event).state())
                .toList();
    }

    /** An active call, both radio connections up. */
    ActiveCall activeCall(String from, String to) {
        TestMobile caller = attach(from);
        TestMobile called = attach(to);
        caller.dial(to);
        caller.next(CallControl.CallProceeding.class);
        called.ring();
        caller.next(CallControl.Alerting.class);
        called.tell(new CallControl.Connect(ActiveCall.CALLED_TRANSACTION));
        called.next(CallControl.ConnectAcknowledge.class);
        caller.next(CallControl.Connect.class);
        caller.tell(new CallControl.ConnectAcknowledge(TestMobile.OUR_CALL));
        return new ActiveCall(caller, called);
    }

    static Optional<Msisdn> number(String digits) {
        return Optional.of(new Msisdn(digits));
    }
}
