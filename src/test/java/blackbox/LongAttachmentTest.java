package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.KeepAlive;
import simgsm.abis.RslMessage;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.mobile.MobilePort;
import simgsm.cells.network.CellNetwork;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.SpeechSocket;
import simgsm.cells.tower.TowerPort;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.center.subscriber.HomeRegister;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/** Phones that are idle for three hours stay attached: the cores of phone, towers and exchange with one clock moved by hand. */
class LongAttachmentTest {
    private static final long HOURS_NANOS = TimeUnit.HOURS.toNanos(3);
    private static final Msisdn NUMBER = new Msisdn("5550100");
    private static final OctetString KEY = OctetString.ofHex("000102030405060708090a0b0c0d0e0f");
    private static final SimCard CARD = new SimCard(Imsi.ofOpenNumber(NUMBER), NUMBER, KEY, KEY);

    private final Deque<Runnable> underWay = new ArrayDeque<>();
    private final List<String> events = new ArrayList<>();
    private long now;
    private Exchange exchange;
    private MobileStation station;
    private Optional<CellNetwork> town = Optional.empty();

    private void begin(HomeRegister home, Sim sim) {
        exchange = new Exchange(
                new ExchangeSettings(
                        "SimGSM",
                        new SplittableRandom(1),
                        Instant.parse("2026-11-21T12:00:00Z"),
                        home,
                        Optional.empty()),
                (ticket, entries) -> underWay.add(() -> exchange.committed(now, ticket, true)),
                this::note);
        station = new MobileStation(
                StationIdentity.ofOpenNumber(NUMBER, new Imei("490154203237518"), "SimGSM phone"),
                sim,
                StationOptions.STANDARD,
                SpeechSource.SILENCE,
                this::note);
    }

    private void note(ExchangeEvent event) {
        if (event instanceof ExchangeEvent.Attached || event instanceof ExchangeEvent.Detached) {
            events.add("exchange " + event.getClass().getSimpleName());
        }
    }

    private void note(StationEvent event) {
        if (event instanceof StationEvent.StationRegistered || event instanceof StationEvent.StationUnregistered) {
            events.add("phone " + event.getClass().getSimpleName());
        }
    }

    private void settle() {
        for (Runnable next = underWay.poll(); next != null; next = underWay.poll()) {
            next.run();
        }
    }

    /** To each deadline of one of the cores in turn. */
    private void pass(long nanos) {
        long end = now + nanos;
        settle();
        for (long next = nextNanos(); next <= end; next = nextNanos()) {
            now = Math.max(now, next);
            town.ifPresent(network -> network.advance(now));
            station.timePassed(now);
            exchange.advance(now);
            settle();
        }
        now = end;
    }

    private long nextNanos() {
        OptionalLong ofTown = town.map(CellNetwork::nextDeadlineNanos).orElse(OptionalLong.empty());
        long ofExchange = exchange.nextDeadlineNanos().orElse(Long.MAX_VALUE);
        return Math.min(Math.min(station.nextDeadlineNanos(), ofExchange), ofTown.orElse(Long.MAX_VALUE));
    }

    /** The station's end of its connection. */
    private record StationPort(Deque<Runnable> underWay, Consumer<IpaFrame> peer) implements Uplink {
        @Override
        public void send(IpaFrame frame) {
            underWay.add(() -> peer.accept(frame));
        }

        @Override
        public void drop() {
            throw new AssertionError("the phone dropped its link");
        }
    }

    /** The exchange's end of a connection. */
    private record ExchangePort(Deque<Runnable> underWay, Consumer<IpaFrame> peer) implements LinkPort {
        @Override
        public void send(IpaFrame frame) {
            underWay.add(() -> peer.accept(frame));
        }

        @Override
        public void close(String reason) {
            throw new AssertionError("the exchange closed a link: " + reason);
        }
    }

    private void connectStation(Consumer<IpaFrame> peer) {
        station.linkUp(new StationPort(underWay, peer), now);
    }

    private void connectDirectly() {
        Peer peer = exchange.linkOpened(
                now, new ExchangePort(underWay, frame -> station.frameArrived(frame, now)), "127.0.0.1:1");
        connectStation(frame -> exchange.frameReceived(now, peer, frame));
    }

    private void connectOverTowers() {
        CellNetwork network = new CellNetwork(
                new Town(List.of(new Tower("west", new TownPlace(0, 0), 30, 43, 100, 10, 1, 6969))),
                7,
                (MobileEvent event) -> {});
        town = Optional.of(network);
        BaseStation tower = network.towers().get(0);
        Peer peer = exchange.linkOpened(now, new ExchangePort(underWay, tower::frameArrived), "127.0.0.1:1");
        tower.connected(new TowerPort() {
            @Override
            public void send(IpaFrame frame) {
                underWay.add(() -> exchange.frameReceived(now, peer, frame));
            }

            @Override
            public Optional<SpeechSocket> openSpeech(Consumer<byte[]> received) {
                return Optional.empty();
            }

            @Override
            public void drop(String reason) {
                throw new AssertionError("the tower dropped its link: " + reason);
            }
        });
        network.place(NUMBER.digits(), new TownPlace(500, 0));
        pass(TimeUnit.SECONDS.toNanos(1));
        MobilePort port = new MobilePort() {
            @Override
            public void send(IpaFrame frame) {
                underWay.add(() -> station.frameArrived(frame, now));
            }

            @Override
            public void close(String reason) {
                throw new AssertionError("the town closed the phone's link: " + reason);
            }
        };
        Mobile mobile = network.connected(port, "127.0.0.1:2");
        KeepAlive keepAlive = new KeepAlive(network.timers(), message -> port.send(ccm(message)), port::close);
        keepAlive.start();
        port.send(ccm(new CcmMessage.IdentityRequest()));
        connectStation(frame -> {
            keepAlive.heard();
            try {
                if (frame.stream() == IpaFrame.RSL) {
                    mobile.arrived(RslMessage.decode(frame.payload()));
                } else if (frame.stream() == IpaFrame.CCM) {
                    keepAlive.receive(CcmCodec.decode(frame.payload()));
                }
            } catch (ProtocolViolation e) {
                throw new AssertionError(e);
            }
        });
    }

    private static IpaFrame ccm(CcmMessage message) {
        return new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message));
    }

    private void expectAttachedForHours() {
        pass(HOURS_NANOS);
        assertEquals(List.of("exchange Attached", "phone StationRegistered"), events);
        assertEquals(1, exchange.attachedCount());
        assertEquals(1, exchange.linkCount());
        assertTrue(station.snapshot().registered());
    }

    @Test
    void aPhoneOnALinkOfItsOwnStaysAttachedWithoutUpdating() {
        begin(HomeRegister.OPEN, Sim.WITHOUT_KEY);
        connectDirectly();

        expectAttachedForHours();
    }

    @Test
    void aPhoneOverTowersStaysAttachedByPeriodicUpdating() {
        begin(HomeRegister.OPEN, Sim.WITHOUT_KEY);
        connectOverTowers();

        expectAttachedForHours();
    }

    @Test
    void aPhoneOverTowersOfAClosedNetworkStaysAttachedByPeriodicUpdating() {
        begin(HomeRegister.closed(List.of(new Subscription(CARD, false)), List.of()), Sim.of(CARD));
        connectOverTowers();

        expectAttachedForHours();
    }

    @Test
    void supervisionOfSilenceLeavesNoTimersBehind() {
        begin(HomeRegister.OPEN, Sim.WITHOUT_KEY);
        connectOverTowers();
        pass(TimeUnit.MINUTES.toNanos(1));
        int idle = exchange.timers().size();
        for (int i = 0; i < 10; i++) {
            station.powerOff();
            pass(TimeUnit.SECONDS.toNanos(20));
            station.powerOn();
            pass(TimeUnit.SECONDS.toNanos(20));
        }

        assertEquals(1, exchange.attachedCount());
        assertEquals(idle, exchange.timers().size());
    }
}
