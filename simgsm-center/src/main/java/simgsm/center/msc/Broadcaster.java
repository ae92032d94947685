package simgsm.center.msc;

/** Cell broadcast (TS 23.041): the same pages to everybody who is attached. */
final class Broadcaster {
    private final Mobility mobility;

    Broadcaster(Mobility mobility) {
        this.mobility = mobility;
    }

    int broadcast(int channel, String text) {
        throw new UnsupportedOperationException();
    }
}
