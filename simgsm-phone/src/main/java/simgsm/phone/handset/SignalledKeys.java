package simgsm.phone.handset;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Supplier;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;

/**
 * Keys as messages: the station sends START DTMF and STOP DTMF, the network makes the sound. What is heard here is the
 * phone's own, for as long as the network lets the key sound; nothing of it is said.
 */
final class SignalledKeys implements KeyWay {
    private static final int TONE_MILLIS = 100;

    private final Supplier<StationSide> station;
    private final Consumer<DtmfKey> left;
    private final DtmfGenerator sidetone = new DtmfGenerator();

    /** @param left told each key whose tone is over at the far end */
    SignalledKeys(Supplier<StationSide> station, Consumer<DtmfKey> left) {
        this.station = station;
        this.left = left;
    }

    @Override
    public void enqueue(DtmfKey key) {
        station.get().signalKey(key, TONE_MILLIS);
    }

    @Override
    public void press(DtmfKey key) {
        station.get().holdKey(key);
    }

    @Override
    public void release() {
        station.get().letGoKey();
    }

    /** The station forgets its keys at the end of each call by itself. */
    @Override
    public void drop() {
        sidetone.drop();
    }

    @Override
    public DtmfKey sounding() {
        return sidetone.sounding();
    }

    @Override
    public void read(short[] said, short[] heard) {
        Arrays.fill(said, (short) 0);
        sidetone.read(heard);
    }

    // What the station tells.

    void sounds(DtmfKey key) {
        sidetone.press(key);
    }

    void letGo() {
        sidetone.release();
    }

    void left(DtmfKey key) {
        left.accept(key);
    }
}
