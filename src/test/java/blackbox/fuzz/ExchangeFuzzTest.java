package blackbox.fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;

/**
 * Stations in dialogues with an exchange, mutated on the way, under a clock moved by hand: nothing is thrown, no number is
 * held twice, and when all stations have gone the exchange holds no state of them.
 */
class ExchangeFuzzTest {
    private static final int PEERS = 6;
    private static final long FRAMES = LongRun.frames(6_000);

    private static final class FuzzPeer {
        final FuzzStation fuzz;
        final Deque<byte[]> up = new ArrayDeque<>();
        final Deque<IpaFrame> down = new ArrayDeque<>();
        IpaFramer framer;
        Peer link;
        boolean isClosed;

        FuzzPeer(FuzzStation fuzz) {
            this.fuzz = fuzz;
        }
    }

    private final List<FuzzPeer> peers = new ArrayList<>();
    private final Deque<Long> uncommitted = new ArrayDeque<>();
    private final Exchange exchange = new Exchange(
            new ExchangeSettings("SimGSM", 1, Instant.parse("2026-11-21T12:00:00Z")),
            (ticket, entry) -> uncommitted.add(ticket),
            event -> {});
    private SplittableRandom random;
    private long nowNanos;

    @ParameterizedTest
    @MethodSource("blackbox.fuzz.LongRun#seeds")
    void spoiltDialoguesDoTheExchangeNoHarm(long seed) {
        random = new SplittableRandom(seed);
        List<Msisdn> numbers = new ArrayList<>();
        for (int i = 0; i < PEERS; i++) {
            numbers.add(new Msisdn(String.valueOf(7_900_000 + i)));
        }
        numbers.forEach(number -> peers.add(new FuzzPeer(new FuzzStation(number, numbers, random.split()))));
        long calls = 0;
        while (frames() < FRAMES) {
            step(peers.get(random.nextInt(PEERS)));
            assertTrue(exchange.linkCount() <= PEERS, "a link without a peer is held");
            calls += exchange.calls().size();
        }
        assertTrue(calls > 0, "no call ever stood");
        leave();
    }

    private long frames() {
        return peers.stream().mapToLong(peer -> peer.fuzz.frames()).sum();
    }

    private void step(FuzzPeer peer) {
        nowNanos += random.nextInt(50) == 0
                ? random.nextLong(Duration.ofSeconds(40).toNanos())
                : random.nextLong(Duration.ofMillis(40).toNanos());
        exchange.advance(nowNanos);
        if (peer.link == null) {
            connect(peer);
        }
        peer.fuzz.turn(nowNanos);
        upwards(peer);
        commit();
        for (IpaFrame frame = peer.down.poll(); frame != null; frame = peer.down.poll()) {
            peer.fuzz.arrived(frame, nowNanos);
        }
        if (peer.isClosed || peer.fuzz.wantsNewConnection()) {
            disconnect(peer);
        }
    }

    private void connect(FuzzPeer peer) {
        peer.framer = new IpaFramer();
        peer.isClosed = false;
        peer.link = exchange.linkOpened(
                nowNanos,
                new LinkPort() {
                    @Override
                    public void send(IpaFrame frame) {
                        peer.down.add(frame);
                    }

                    @Override
                    public void close(String reason) {
                        peer.isClosed = true;
                    }
                },
                "peer");
        peer.fuzz.connected(peer.up::add, nowNanos);
    }

    private void upwards(FuzzPeer peer) {
        try {
            for (byte[] octets = peer.up.poll(); octets != null; octets = peer.up.poll()) {
                peer.framer.accept(ByteBuffer.wrap(octets));
                for (Optional<IpaFrame> frame = peer.framer.next();
                        frame.isPresent() && !peer.isClosed;
                        frame = peer.framer.next()) {
                    exchange.frameReceived(nowNanos, peer.link, frame.get());
                }
            }
        } catch (ProtocolViolation violation) {
            peer.isClosed = true;
        }
    }

    private void commit() {
        for (Long ticket = uncommitted.poll(); ticket != null; ticket = uncommitted.poll()) {
            exchange.committed(nowNanos, ticket, random.nextInt(20) > 0);
        }
    }

    private void disconnect(FuzzPeer peer) {
        exchange.linkClosed(nowNanos, peer.link, "gone");
        peer.link = null;
        peer.up.clear();
        peer.down.clear();
        peer.fuzz.disconnected(nowNanos);
    }

    private void leave() {
        peers.stream().filter(peer -> peer.link != null).forEach(peer -> disconnect(peer));
        assertEquals(0, exchange.linkCount());
        assertTrue(exchange.calls().isEmpty(), exchange.calls().toString());
        assertTrue(exchange.subscribers().stream().noneMatch(subscriber -> subscriber.isAttached()));
        // First the messages expire, the longest after 63 weeks, then the reports about them.
        for (int i = 0; i < 2; i++) {
            nowNanos += Duration.ofDays(7 * 64).toNanos();
            exchange.advance(nowNanos);
            commit();
        }
        exchange.advance(nowNanos + Duration.ofDays(7 * 64).toNanos());
        assertEquals(0, exchange.shortMessages().waitingCount());
    }
}
