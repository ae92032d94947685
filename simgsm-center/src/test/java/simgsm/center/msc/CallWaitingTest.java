package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.center.subscriber.HomeRegister;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/** Three real station cores and an exchange with call waiting, under a clock moved by hand. */
class CallWaitingTest {
    private static final String ALICE = "5550100";
    private static final String BOB = "5550101";
    private static final String CAROL = "5550102";
    private static final long MILLI = 1_000_000;

    private final class Phone {
        final MobileStation station;
        final List<String> told = new ArrayList<>();
        final Deque<IpaFrame> up = new ArrayDeque<>();
        final Deque<IpaFrame> down = new ArrayDeque<>();
        final Peer link;

        Phone(String number, boolean takesWaiting) {
            station = new MobileStation(
                    StationIdentity.ofOpenNumber(
                            new Msisdn(number), Imei.of("00101753", Integer.parseInt(number) % 1_000_000), "test"),
                    Sim.WITHOUT_KEY,
                    new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE, takesWaiting),
                    SpeechSource.SILENCE,
                    this::note,
                    new SplittableRandom(1));
            link = exchange.linkOpened(
                    nowNanos,
                    new LinkPort() {
                        @Override
                        public void send(IpaFrame frame) {
                            down.add(frame);
                        }

                        @Override
                        public void close(String reason) {
                            told.add("closed");
                        }
                    },
                    number);
            station.linkUp(
                    new Uplink() {
                        @Override
                        public void send(IpaFrame frame) {
                            up.add(frame);
                        }

                        @Override
                        public void drop() {
                            told.add("dropped");
                        }
                    },
                    nowNanos);
            phones.add(this);
            settle();
        }

        private void note(StationEvent event) {
            if (event instanceof StationEvent.Ringing ringing) {
                told.add("ringing " + ringing.from().orElseThrow());
            } else if (event instanceof StationEvent.CallWaits waiting) {
                told.add("waiting " + waiting.from().orElseThrow());
            } else if (event instanceof StationEvent.WaitingCallEnded) {
                told.add("waiting over");
            } else if (event instanceof StationEvent.CalledPartyAlerted) {
                told.add("alerting");
            } else if (event instanceof StationEvent.Connected connected) {
                told.add("connected " + connected.peer().orElseThrow());
            } else if (event instanceof StationEvent.Released released) {
                told.add("released " + released.cause().code());
            }
        }

        void dial(String number) {
            station.dial(new Msisdn(number));
            settle();
        }

        List<String> news() {
            List<String> news = List.copyOf(told);
            told.clear();
            return news;
        }
    }

    private long nowNanos;
    private final List<Phone> phones = new ArrayList<>();
    private final Exchange exchange = new Exchange(
            new ExchangeSettings(
                    "SimGSM",
                    new SplittableRandom(1),
                    Instant.parse("2026-11-21T12:00:00Z"),
                    HomeRegister.OPEN,
                    Optional.empty(),
                    true,
                    Locale.ENGLISH,
                    false),
            (ticket, entry) -> {},
            event -> {});
    private final Phone alice = new Phone(ALICE, true);
    private final Phone bob = new Phone(BOB, true);
    private final Phone carol = new Phone(CAROL, true);

    /** Hands frames over until nobody has any, then lets 20 ms pass, some times. */
    private void settle() {
        for (int i = 0; i < 10; i++) {
            while (phones.stream().anyMatch(phone -> !phone.up.isEmpty() || !phone.down.isEmpty())) {
                for (Phone phone : phones) {
                    for (IpaFrame frame = phone.up.poll(); frame != null; frame = phone.up.poll()) {
                        exchange.frameReceived(nowNanos, phone.link, frame);
                    }
                    for (IpaFrame frame = phone.down.poll(); frame != null; frame = phone.down.poll()) {
                        phone.station.frameArrived(frame, nowNanos);
                    }
                }
            }
            nowNanos += 20 * MILLI;
            exchange.advance(nowNanos);
            phones.forEach(phone -> phone.station.timePassed(nowNanos));
        }
    }

    private void aliceTalksWithBob() {
        alice.dial(BOB);
        bob.station.answer();
        settle();
        assertEquals(List.of("ringing 5550100", "connected 5550100"), bob.news());
        alice.news();
    }

    @Test
    void aSecondCallWaitsAndRingsWhenTheFirstHasEnded() {
        aliceTalksWithBob();
        carol.dial(BOB);
        assertEquals(List.of("waiting 5550102"), bob.news());
        assertEquals(List.of("alerting"), carol.news());
        bob.station.hangUp();
        settle();
        assertEquals(List.of("released 16", "ringing 5550102"), bob.news());
        assertEquals(List.of("released 16"), alice.news());
        bob.station.answer();
        settle();
        assertEquals(List.of("connected 5550102"), bob.news());
        assertEquals(List.of("connected 5550101"), carol.news());
        carol.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), bob.news());
        assertTrue(exchange.calls().isEmpty());
    }

    @Test
    void whenTheFirstCallersHangsUpTheSecondRings() {
        aliceTalksWithBob();
        carol.dial(BOB);
        bob.news();
        alice.station.hangUp();
        settle();
        assertEquals(List.of("released 16", "ringing 5550102"), bob.news());
    }

    @Test
    void whoWaitedAndGivesUpLeavesTheFirstCallAlone() {
        aliceTalksWithBob();
        carol.dial(BOB);
        carol.station.hangUp();
        settle();
        assertEquals(List.of("waiting 5550102", "waiting over"), bob.news());
        assertEquals(1, exchange.calls().size());
        alice.dial(CAROL);
        bob.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), bob.news());
    }

    @Test
    void aThirdCallFindsTheNumberBusy() {
        aliceTalksWithBob();
        carol.dial(BOB);
        Phone dave = new Phone("5550103", true);
        dave.dial(BOB);
        assertEquals(List.of("released 17"), dave.news());
        assertEquals(List.of("waiting 5550102"), bob.news());
    }

    @Test
    void whoRingsButDoesNotTalkYetIsBusy() {
        alice.dial(BOB);
        carol.dial(BOB);
        assertEquals(List.of("released 17"), carol.news());
    }

    @Test
    void aTerminalThatTakesNoWaitingCallAnswersBusyItself() {
        Phone robot = new Phone("5550200", false);
        alice.dial("5550200");
        robot.station.answer();
        settle();
        carol.dial("5550200");
        assertEquals(List.of("released 17"), carol.news());
        assertEquals(List.of("ringing 5550100", "connected 5550100"), robot.news());
    }

    @Test
    void whoWaitsThreeMinutesIsReleasedWithCause19() {
        aliceTalksWithBob();
        carol.dial(BOB);
        for (int i = 0; i < 1_000; i++) {
            settle();
        }
        assertEquals(List.of("alerting", "released 19"), carol.news());
        assertEquals(List.of("waiting 5550102", "waiting over"), bob.news());
        assertEquals(1, exchange.calls().size());
    }

    @Test
    void whoWaitsIsToldWhenTheMobileIsGone() {
        aliceTalksWithBob();
        carol.dial(BOB);
        carol.news();
        bob.station.powerOff();
        settle();
        assertTrue(carol.news().get(0).startsWith("released "), "still waits");
        assertTrue(exchange.calls().isEmpty());
    }
}
