package simgsm.tools.load;

import java.util.Arrays;
import simgsm.air.Cause;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;

/** One station of the load: answers calls, numbers its speech frames, and reports events to the generator. */
final class LoadStation implements SpeechSource {
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

        /** True if speech is counted now. */
        boolean isCounting();

        /** A numbered frame is sent. */
        void spoke();

        /** @param nanos from sending at the other end to arrival here */
        void heard(long nanos);
    }

    final int index;
    final MobileStation station;
    private final Observer observer;
    private final long answerAfterNanos;
    private final long[] sentNanos = new long[SpeechFrameNumber.COUNT];
    private int nextNumber;
    private int heardNumber = SpeechFrameNumber.NONE;
    /** The other end of a call of the generator; null otherwise. */
    private LoadStation partner;

    /** @param answerAfterNanos ringing time; 0 for none */
    LoadStation(int index, Msisdn number, long answerAfterNanos, Observer observer) {
        this.index = index;
        this.answerAfterNanos = answerAfterNanos;
        this.observer = observer;
        Imei imei = Imei.of(TYPE_ALLOCATION_CODE, (int) (Long.parseLong(number.digits()) % SERIAL_NUMBERS));
        StationIdentity identity = StationIdentity.ofOpenNumber(number, imei, "SimGSM load");
        station = new MobileStation(identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, this, this::accept);
    }

    Msisdn number() {
        return station.identity().number();
    }

    void setPartner(LoadStation other) {
        partner = other;
    }

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.SpeechReceived speech) {
            hear(speech.samples());
        } else if (event instanceof StationEvent.StationRegistered) {
            observer.attached(this);
        } else if (event instanceof StationEvent.StationUnregistered unregistered) {
            observer.refused(
                    this, unregistered.cause().map(RejectCause::toString).orElse("no service"));
        } else if (event instanceof StationEvent.Ringing && answerAfterNanos > 0) {
            station.remindToAnswer(answerAfterNanos);
        } else if (event instanceof StationEvent.Ringing || event instanceof StationEvent.AnswerDue) {
            station.answer();
        } else if (event instanceof StationEvent.Connected) {
            observer.connected(this);
        } else if (event instanceof StationEvent.Released released) {
            observer.released(this, released.cause());
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            observer.messageArrived(message.text());
        } else if (event instanceof StationEvent.MessageFailed failed) {
            observer.messageFailed(failed.id(), this, failed.cause());
        }
    }

    /** Numbers the frame, which is sent at once. */
    @Override
    public void read(short[] frame) {
        if (partner == null || !observer.isCounting()) {
            Arrays.fill(frame, (short) 0);
            return;
        }
        SpeechFrameNumber.put(frame, nextNumber);
        sentNanos[nextNumber] = System.nanoTime();
        nextNumber = (nextNumber + 1) % SpeechFrameNumber.COUNT;
        observer.spoke();
    }

    /** The substitute of a lost frame repeats the last one, so an equal number is not counted again. */
    private void hear(short[] samples) {
        int number = SpeechFrameNumber.read(samples);
        if (partner != null && number != SpeechFrameNumber.NONE && number != heardNumber) {
            heardNumber = number;
            observer.heard(System.nanoTime() - partner.sentNanos[number]);
        }
    }
}
