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
    private Tmsi formerTmsi;
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

    /** Whether the mobile may call itself so: until it has confirmed a new temporary identity the one before holds too. */
    public boolean answersTo(Tmsi candidate) {
        return candidate.equals(tmsi) || candidate.equals(formerTmsi);
    }

    Optional<Tmsi> formerTmsi() {
        return Optional.ofNullable(formerTmsi);
    }

    void tmsi(Tmsi newTmsi) {
        formerTmsi = tmsi;
        tmsi = newTmsi;
    }

    void forgetFormerTmsi() {
        formerTmsi = null;
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
