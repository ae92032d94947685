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

/** One station of the load: answers calls, numbers its speech frames, and reports events to the generator. */
final class LoadStation implements StationListener, SpeechSource {
    /** A type of test equipment other than that of the phones, so that no IMEI occurs twice. */
    private static final String TYPE_ALLOCATION_CODE = "00101751";

    private static final int SERIAL_NUMBERS = 1_000_000;

    /** Events of the stations, on their thread. */
    interface Observer {
        void attached(LoadStation phone);

        /** Registration failed or ended. */
        void refused(LoadStation phone, String reason);

        void connected(LoadStation phone);

        void released(LoadStation phone, Cause cause);

        void messageArrived(String text);

        void messageFailed(int id, LoadStation from, RpCause cause);

        /** Whether speech is counted now. */
        boolean isCounting();

        /** A numbered frame is sent. */
        void spoke();

        /** @param nanos from sending at the other end to arrival here */
        void heard(long nanos);
    }

    /** Frames of 20 ms whose times are kept: 5 s; later ones count as lost. */
    private static final int KEPT_FRAMES = 256;

    final int index;
    final MobileStation station;
    private final Observer observer;
    private final long[] sentNanos = new long[KEPT_FRAMES];
    private int nextNumber;
    /** The other end of a call of the generator; null otherwise. */
    private LoadStation partner;

    LoadStation(int index, Msisdn number, Observer observer) {
        this.index = index;
        this.observer = observer;
        Imei imei = Imei.of(TYPE_ALLOCATION_CODE, (int) (Long.parseLong(number.digits()) % SERIAL_NUMBERS));
        StationIdentity identity = StationIdentity.ofOpenNumber(number, imei, "SimGSM load");
        station = new MobileStation(identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, this, this);
    }

    Msisdn number() {
        return station.identity().number();
    }

    void setPartner(LoadStation other) {
        partner = other;
    }

    @Override
    public void registered(Msisdn number) {
        observer.attached(this);
    }

    @Override
    public void unregistered(Optional<RejectCause> cause) {
        observer.refused(this, cause.map(RejectCause::toString).orElse("no service"));
    }

    @Override
    public void ringing(Optional<Msisdn> from) {
        station.answer();
    }

    @Override
    public void connected(Optional<Msisdn> peer) {
        observer.connected(this);
    }

    @Override
    public void released(Cause cause) {
        observer.released(this, cause);
    }

    @Override
    public void messageReceived(String from, String text) {
        observer.messageArrived(text);
    }

    @Override
    public void messageFailed(int id, Msisdn to, RpCause cause) {
        observer.messageFailed(id, this, cause);
    }

    /** Numbers the frame, which is sent at once. */
    @Override
    public void read(short[] frame) {
        if (partner == null || !observer.isCounting()) {
            Arrays.fill(frame, (short) 0);
            return;
        }
        SpeechFrameNumber.put(frame, nextNumber);
        sentNanos[nextNumber % KEPT_FRAMES] = System.nanoTime();
        nextNumber = nextNumber + 1 & SpeechFrameNumber.LARGEST;
        observer.spoke();
    }

    @Override
    public void speechReceived(short[] samples) {
        int number = SpeechFrameNumber.read(samples);
        if (partner != null && number != SpeechFrameNumber.NONE) {
            observer.heard(System.nanoTime() - partner.sentNanos[number % KEPT_FRAMES]);
        }
    }
}
