package simgsm.center.subscriber;

import java.util.Optional;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.air.Tmsi;

/** One subscriber: the number and identity for good, the equipment and temporary identity while attached. */
public final class Subscriber {
    private final Msisdn number;
    private final Imsi imsi;
    private Imei imei;
    private Tmsi tmsi;
    private boolean attached;
    private boolean entered;

    Subscriber(Msisdn number, Imsi imsi) {
        this.number = number;
        this.imsi = imsi;
    }

    public Msisdn number() {
        return number;
    }

    public Imsi imsi() {
        return imsi;
    }

    /** The equipment that last registered with this SIM. */
    public Optional<Imei> imei() {
        return Optional.ofNullable(imei);
    }

    public Optional<Tmsi> tmsi() {
        return Optional.ofNullable(tmsi);
    }

    public boolean isAttached() {
        return attached;
    }

    /** Returns whether this is the first time. */
    boolean enter() {
        boolean isFirst = !entered;
        entered = true;
        return isFirst;
    }

    void tmsi(Tmsi newTmsi) {
        tmsi = newTmsi;
    }

    void attach(Imei equipment) {
        imei = equipment;
        attached = true;
    }

    void detach() {
        attached = false;
    }

    @Override
    public String toString() {
        return number.digits();
    }
}
