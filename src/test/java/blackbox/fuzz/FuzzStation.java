package blackbox.fuzz;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/**
 * A station core with random actions. Some of its frames are mutated, lost, repeated or replaced. The caller supplies
 * connection and time.
 */
final class FuzzStation {
    private static final int LONGEST_TEXT = 320;
    private static final int LONGEST_TONE_MILLIS = 300;

    private final SplittableRandom random;
    private final Mutator mutator;
    private final List<RecordedFrames.Sample> traffic;
    private final List<Msisdn> others;
    private final MobileStation station;
    /** Null without a connection. */
    private Consumer<byte[]> wire;

    private boolean isDropped;
    private boolean isFramingBroken;
    private long frames;

    /** @param others numbers that it calls and sends messages to */
    FuzzStation(Msisdn number, List<Msisdn> others, SplittableRandom random) {
        this.random = random;
        this.others = List.copyOf(others);
        mutator = new Mutator(random);
        traffic = RecordedFrames.read().stream()
                .filter(sample -> sample.direction() == Direction.UPLINK)
                .toList();
        station = new MobileStation(
                StationIdentity.ofOpenNumber(number, Imei.random(random), "SimGSM fuzz"),
                Sim.WITHOUT_KEY,
                StationOptions.STANDARD,
                SpeechSource.SILENCE,
                this::accept,
                random);
    }

    /** Begins a connection. @param newWire receives octets for the centre, mostly whole frames */
    void connected(Consumer<byte[]> newWire, long nowNanos) {
        wire = newWire;
        isDropped = false;
        isFramingBroken = false;
        station.linkUp(
                new Uplink() {
                    @Override
                    public void send(IpaFrame frame) {
                        pass(frame);
                    }

                    @Override
                    public void drop() {
                        isDropped = true;
                    }
                },
                nowNanos);
    }

    void disconnected(long nowNanos) {
        wire = null;
        station.linkDown(nowNanos);
    }

    void arrived(IpaFrame frame, long nowNanos) {
        station.frameArrived(frame, nowNanos);
    }

    /** True if the connection should be replaced. */
    boolean wantsNewConnection() {
        return isDropped || isFramingBroken && random.nextInt(4) == 0 || random.nextInt(5_000) == 0;
    }

    /** Frames sent, mutated or not. */
    long frames() {
        return frames;
    }

    /** Advances the time and performs a random action. */
    void turn(long nowNanos) {
        station.timePassed(nowNanos);
        switch (random.nextInt(60)) {
            case 0, 1 -> station.dial(anyNumber());
            case 2 -> station.hangUp();
            case 3, 4 -> station.sendMessage(anyNumber(), "x".repeat(1 + random.nextInt(LONGEST_TEXT)));
            case 5 -> station.signalKey(DtmfKey.values()[random.nextInt(DtmfKey.values().length)], tone());
            case 6 -> rarely(station::powerOff);
            case 7, 8 -> station.powerOn();
            case 9, 10, 11 -> sendRecorded();
            default -> {}
        }
    }

    private int tone() {
        return 70 + random.nextInt(LONGEST_TONE_MILLIS);
    }

    private void rarely(Runnable act) {
        if (random.nextInt(10) == 0) {
            act.run();
        }
    }

    private Msisdn anyNumber() {
        return others.get(random.nextInt(others.size()));
    }

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.Ringing && random.nextInt(3) > 0) {
            station.answer();
        }
    }

    private void pass(IpaFrame frame) {
        int percent = random.nextInt(100);
        if (percent < 80) {
            send(IpaFramer.encode(frame));
        } else if (percent < 90) {
            send(IpaFramer.encode(mutated(frame)));
        } else if (percent < 94) {
            send(IpaFramer.encode(frame));
            send(IpaFramer.encode(frame));
        } else if (percent < 98) {
            sendRecorded();
        } else if (percent < 99) {
            breakFraming(frame);
        }
        // The remaining 1 % is lost.
    }

    private IpaFrame mutated(IpaFrame frame) {
        return new IpaFrame(frame.stream(), mutator.mutate(frame.payload(), IpaFrame.MAX_PAYLOAD));
    }

    /** Sends a recorded frame of another station. */
    private void sendRecorded() {
        IpaFrame frame = traffic.get(random.nextInt(traffic.size())).frame();
        send(IpaFramer.encode(random.nextBoolean() ? frame : mutated(frame)));
    }

    private void breakFraming(IpaFrame frame) {
        isFramingBroken = true;
        send(mutator.mutate(IpaFramer.encode(frame), IpaFrame.MAX_PAYLOAD));
    }

    private void send(byte[] octets) {
        if (wire != null) {
            frames++;
            wire.accept(octets);
        }
    }
}
