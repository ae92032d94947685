package simgsm.tools.load;

import java.util.Arrays;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.station.MobileStation;
import simgsm.station.Sim;
import simgsm.station.SpeechSource;
import simgsm.station.StationIdentity;
import simgsm.station.StationListener;
import simgsm.station.StationOptions;

/** One station of the load: answers whoever calls, marks what it says, and tells the run what happens. */
final class LoadPhone implements StationListener, SpeechSource {
    /** Of a test equipment, and not that of the phones, so that no two terminals have the same. */
    private static final String TYPE_ALLOCATION_CODE = "00101751";

    private static final int SERIAL_NUMBERS = 1_000_000;

    /** What the run hears from its phones, on the stations' thread. */
    interface Host {
        void attached(LoadPhone phone);

        /** Not attached, or no longer. */
        void refused(LoadPhone phone, String reason);

        void connected(LoadPhone phone);

        void released(LoadPhone phone, Cause cause);

        void messageArrived(String text);

        void messageFailed(int id, LoadPhone from, RpCause cause);

        /** Whether what is said is counted just now. */
        boolean isCounting();

        void spoke();

        /** @param nanos from the far end's sending to its arrival here */
        void heard(long nanos);
    }

    /** Speech under way longer than 5 s has been lost. */
    private static final int REMEMBERED_FRAMES = 256;

    final int index;
    final MobileStation station;
    private final Host host;
    private final long[] sentNanos = new long[REMEMBERED_FRAMES];
    private int nextMark;
    /** Who is at the other end of a call; null outside the calls of the run. */
    private LoadPhone partner;

    LoadPhone(int index, Msisdn number, Host host) {
        this.index = index;
        this.host = host;
        Imei imei = Imei.of(TYPE_ALLOCATION_CODE, (int) (Long.parseLong(number.digits()) % SERIAL_NUMBERS));
        StationIdentity identity = StationIdentity.ofOpenNumber(number, imei, "SimGSM load");
        station = new MobileStation(identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, this, this);
    }

    Msisdn number() {
        return station.identity().number();
    }

    void talksWith(LoadPhone other) {
        partner = other;
    }

    @Override
    public void registered(Msisdn number) {
        host.attached(this);
    }

    @Override
    public void unregistered(Optional<RejectCause> cause) {
        host.refused(this, cause.map(RejectCause::toString).orElse("no service"));
    }

    @Override
    public void ringing(Optional<Msisdn> from) {
        station.answer();
    }

    @Override
    public void connected(Optional<Msisdn> peer) {
        host.connected(this);
    }

    @Override
    public void released(Cause cause) {
        host.released(this, cause);
    }

    @Override
    public void messageReceived(String from, String text) {
        host.messageArrived(text);
    }

    @Override
    public void messageFailed(int id, Msisdn to, RpCause cause) {
        host.messageFailed(id, this, cause);
    }

    /** The next frame leaves now. */
    @Override
    public void read(short[] frame) {
        if (partner == null || !host.isCounting()) {
            Arrays.fill(frame, (short) 0);
            return;
        }
        FrameMark.put(frame, nextMark);
        sentNanos[nextMark % REMEMBERED_FRAMES] = System.nanoTime();
        nextMark = nextMark + 1 & FrameMark.LARGEST;
        host.spoke();
    }

    @Override
    public void speechReceived(short[] samples) {
        int mark = FrameMark.read(samples);
        if (partner != null && mark != FrameMark.NONE) {
            host.heard(System.nanoTime() - partner.sentNanos[mark % REMEMBERED_FRAMES]);
        }
    }
}
