package simgsm.phone.handset;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Supplier;
import simgsm.dtmf.DtmfKey;
import simgsm.station.StationCommands;
import simgsm.station.context.StationEvent;

/**
 * Sends keys as START DTMF and STOP DTMF: the network makes the tones. The generator makes only the sidetone, as long
 * as the network plays the key. The station drops its keys at the end of each call.
 */
final class SignalledKeySender extends KeySender {
    private final Supplier<StationCommands> station;

    SignalledKeySender(Supplier<StationCommands> station, Consumer<String> runSent) {
        super(runSent);
        this.station = station;
    }

    void accept(StationEvent.OfKey event) {
        if (event instanceof StationEvent.KeyStarted started) {
            generator.press(started.key());
        } else if (event instanceof StationEvent.KeyStopping) {
            generator.release();
        } else if (event instanceof StationEvent.KeyCompleted) {
            toneSent();
        }
    }

    @Override
    void enqueue(DtmfKey key, int toneMillis) {
        station.get().signalKey(key, toneMillis);
    }

    @Override
    void hold(DtmfKey key) {
        station.get().holdKey(key);
    }

    @Override
    void up() {
        station.get().releaseKey();
    }

    @Override
    void toneGenerated(DtmfKey key) {
        // The end of the sidetone is not the end of the tone.
    }

    @Override
    void read(short[] speech, short[] heard) {
        Arrays.fill(speech, (short) 0);
        generator.read(heard);
    }
}
