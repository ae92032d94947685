package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import simgsm.abis.IpaFrame;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.msc.link.Peer;
import simgsm.center.subscriber.HomeRegister;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/** Three real station cores and an exchange, under a clock moved by hand. */
abstract class ThreePhones {
    static final String ALICE = "5550100";
    static final String BOB = "5550101";
    static final String CAROL = "5550102";
    private static final long MILLI = 1_000_000;

    final class Phone {
        final MobileStation station;
        final List<String> told = new ArrayList<>();
        /** What is said into this phone, the same in every sample. */
        short level;

        int heardFrames;
        /** Whether the newest hold notification says that the other party holds the call. */
        boolean isOnHold;

        boolean heardSound;
        final Deque<IpaFrame> up = new ArrayDeque<>();
        final Deque<IpaFrame> down = new ArrayDeque<>();
        final Peer link;

        Phone(String number, boolean takesWaiting) {
            station = new MobileStation(
                    StationIdentity.ofOpenNumber(
                            new Msisdn(number), Imei.of("00101753", Integer.parseInt(number) % 1_000_000), "test"),
                    Sim.WITHOUT_KEY,
                    new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE, takesWaiting),
                    frame -> Arrays.fill(frame, level),
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
            } else if (event instanceof StationEvent.ServiceAnswered answer) {
                told.add(answer.status().service().typed()
                        + (answer.status().isActive()
                                ? " active"
                                : answer.status().isRegistered() ? " registered" : " inactive")
                        + answer.status()
                                .forwardedTo()
                                .map(number -> " " + number)
                                .orElse("")
                        + answer.status()
                                .noReplySeconds()
                                .map(seconds -> " after " + seconds + " s")
                                .orElse(""));
            } else if (event instanceof StationEvent.UssdEnded end) {
                told.add("refused " + end.error().map(error -> error.code()).orElse(-1));
            } else if (event instanceof StationEvent.CallHeld held) {
                told.add("held " + held.peer().orElseThrow());
            } else if (event instanceof StationEvent.HeldByPeer) {
                isOnHold = true;
            } else if (event instanceof StationEvent.RetrievedByPeer) {
                isOnHold = false;
            } else if (event instanceof StationEvent.CallRetrieved retrieved) {
                isOnHold = false;
                told.add("retrieved " + retrieved.peer().orElseThrow());
            } else if (event instanceof StationEvent.HeldCallEnded ended) {
                told.add("held over " + ended.cause().code());
            } else if (event instanceof StationEvent.HoldRefused) {
                told.add("hold refused");
            } else if (event instanceof StationEvent.SpeechReceived speech) {
                heardFrames++;
                heardSound |=
                        IntStream.range(0, speech.samples().length).anyMatch(i -> Math.abs(speech.samples()[i]) > 100);
            } else if (event instanceof StationEvent.Released released) {
                told.add("released " + released.cause().code());
            }
        }

        void dial(String number) {
            station.dial(new Msisdn(number));
            settle();
        }

        /** Whether sound of the far end or of the network is heard within a second. */
        boolean hears() {
            heardSound = false;
            seconds(1);
            return heardSound;
        }

        /** Sends a service code. @return what the network answers */
        List<String> code(String code) {
            station.sendUssd(code);
            settle();
            return news();
        }

        List<String> news() {
            List<String> news = List.copyOf(told);
            told.clear();
            return news;
        }
    }

    private long nowNanos;
    private final List<Phone> phones = new ArrayList<>();
    private final Deque<Long> unstored = new ArrayDeque<>();
    /** Whether the disk has room; empty while it has not answered. */
    Optional<Boolean> disk = Optional.of(true);

    final Exchange exchange;
    final Phone alice;
    final Phone bob;
    final Phone carol;

    /** @param callWaiting of subscribers who have not set it */
    ThreePhones(boolean callWaiting) {
        exchange = new Exchange(
                new ExchangeSettings(
                        "SimGSM",
                        new SplittableRandom(1),
                        Instant.parse("2026-11-21T12:00:00Z"),
                        HomeRegister.OPEN,
                        Optional.empty(),
                        callWaiting,
                        Locale.ENGLISH,
                        false,
                        NetworkTimer.T303.nanos(),
                        Optional.empty(),
                        HandoverAlgorithm.STANDARD),
                (ticket, entry) -> unstored.add(ticket),
                event -> {});
        alice = new Phone(ALICE, true);
        bob = new Phone(BOB, true);
        carol = new Phone(CAROL, true);
    }

    /** Hands frames over until none is left, then lets 20 ms pass, some times. */
    final void settle() {
        for (int i = 0; i < 10; i++) {
            while (phones.stream().anyMatch(phone -> !phone.up.isEmpty() || !phone.down.isEmpty())
                    || disk.isPresent() && !unstored.isEmpty()) {
                while (disk.isPresent() && !unstored.isEmpty()) {
                    exchange.committed(nowNanos, unstored.remove(), disk.get());
                }
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

    final void aliceTalksWithBob() {
        alice.dial(BOB);
        bob.station.answer();
        settle();
        assertEquals(List.of("ringing 5550100", "connected 5550100"), bob.news());
        alice.news();
    }

    /** Some seconds pass. */
    final void seconds(int count) {
        for (int i = 0; i < count * 5; i++) {
            settle();
        }
    }
}
