package simgsm.phone.handset;

import java.util.function.Consumer;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;

/** Keys as the phone's own sound, among its speech. */
final class InBandKeys implements KeyWay {
    private final DtmfGenerator generator;

    /** @param left told each key whose tone has left whole */
    InBandKeys(Consumer<DtmfKey> left) {
        generator = new DtmfGenerator(left);
    }

    @Override
    public void enqueue(DtmfKey key) {
        generator.enqueue(key);
    }

    @Override
    public void press(DtmfKey key) {
        generator.press(key);
    }

    @Override
    public void release() {
        generator.release();
    }

    @Override
    public void drop() {
        generator.drop();
    }

    @Override
    public DtmfKey sounding() {
        return generator.sounding();
    }

    @Override
    public void read(short[] said, short[] heard) {
        generator.read(said);
        System.arraycopy(said, 0, heard, 0, said.length);
    }
}
