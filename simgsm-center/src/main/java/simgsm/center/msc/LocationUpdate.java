package simgsm.center.msc;

import java.lang.System.Logger.Level;
import java.time.Duration;
import java.util.Optional;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.center.subscriber.HomeRegister;
import simgsm.center.subscriber.Subscriber;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * One location update (TS 24.008, 4.4.4): who is it, does its card prove it, on which equipment, may it come; then its
 * temporary identity, the network's name, and the channel's release. Nothing is ciphered.
 */
final class LocationUpdate {
    private enum State {
        AWAITING_IMSI,
        AWAITING_PROOF,
        AWAITING_IMEI,
        AWAITING_TMSI_COMPLETE
    }

    private static final System.Logger LOG = System.getLogger(LocationUpdate.class.getName());

    /** T3270, identification, and T3250, TMSI reallocation: 12 s each (TS 24.008, table 11.2). */
    private static final long ANSWER_NANOS = Duration.ofSeconds(12).toNanos();

    private final Link link;
    private final Mobility mobility;
    private final Timers timers;
    private State state;
    private Timer guard;
    /** Who claims to come; not of the register before all has gone well, or whoever is rejected would become known. */
    private Imsi imsi;

    private boolean cameByTmsi;

    LocationUpdate(Link link, Mobility mobility, Timers timers) {
        this.link = link;
        this.mobility = mobility;
        this.timers = timers;
    }

    void start(MobileIdentity identity) {
        if (!link.moderation.admitsRegistration()) {
            reject(RejectCause.CONGESTION);
        } else if (identity instanceof Imsi said) {
            identified(said);
        } else if (identity instanceof Tmsi tmsi) {
            Optional<Subscriber> known = mobility.register().ofTmsi(tmsi);
            if (known.isPresent()) {
                cameByTmsi = true;
                identified(known.get().imsi());
            } else {
                ask(MobileIdentity.Type.IMSI, State.AWAITING_IMSI);
            }
        } else {
            reject(RejectCause.INVALID_MANDATORY_INFORMATION);
        }
    }

    /** Takes an answer of the mobile. Returns false if none of this kind is awaited. */
    boolean receive(MobilityManagement message) {
        if (message instanceof MobilityManagement.IdentityResponse response) {
            return receiveIdentity(response.identity());
        }
        if (message instanceof MobilityManagement.TmsiReallocationComplete && state == State.AWAITING_TMSI_COMPLETE) {
            if (link.subscriber != null) {
                mobility.register().confirmTmsi(link.subscriber);
            }
            link.send(new MobilityManagement.MmInformation(mobility.networkName()));
            end();
            return true;
        }
        return false;
    }

    /** The answer to an identity request breaks the standard: an IMEI with a wrong check digit is no equipment's. */
    void identityIsNone() {
        if (state == State.AWAITING_IMEI) {
            reject(RejectCause.ILLEGAL_ME);
        } else if (state == State.AWAITING_IMSI) {
            reject(RejectCause.INVALID_MANDATORY_INFORMATION);
        }
    }

    private boolean receiveIdentity(MobileIdentity identity) {
        if (state == State.AWAITING_IMSI && identity instanceof Imsi said) {
            if (said.equals(imsi)) {
                rejectCard();
            } else {
                identified(said);
            }
            return true;
        }
        if (state == State.AWAITING_IMEI && identity instanceof Imei imei) {
            equipped(imei);
            return true;
        }
        return false;
    }

    private void identified(Imsi who) {
        HomeRegister home = mobility.register().home();
        imsi = who;
        if (home.numberOf(who).isEmpty()) {
            reject(RejectCause.IMSI_UNKNOWN_IN_HLR);
        } else if (home.cardOf(who).isPresent()) {
            await(State.AWAITING_PROOF);
            link.authenticity.demand(home.cardOf(who).get(), mobility.challenge(), this::proved);
        } else {
            identityHolds();
        }
    }

    /** A temporary identity may have led to the wrong card; then the permanent one is asked for (TS 24.008, 4.3.2.5). */
    private void proved(boolean proven) {
        if (proven) {
            identityHolds();
        } else if (cameByTmsi) {
            cameByTmsi = false;
            ask(MobileIdentity.Type.IMSI, State.AWAITING_IMSI);
        } else {
            rejectCard();
        }
    }

    /** Whoever was registered here before has lost the right to be. */
    private void rejectCard() {
        log("the card does not have its key");
        link.send(new MobilityManagement.AuthenticationReject());
        link.loseTransactions();
        mobility.depart(link);
        end();
    }

    private void identityHolds() {
        if (mobility.register().home().isBarred(imsi)) {
            reject(RejectCause.PLMN_NOT_ALLOWED);
        } else {
            ask(MobileIdentity.Type.IMEI, State.AWAITING_IMEI);
        }
    }

    private void equipped(Imei imei) {
        if (mobility.register().home().isBarred(imei)) {
            reject(RejectCause.ILLEGAL_ME);
            return;
        }
        Optional<Subscriber> subscriber = mobility.register().admit(imsi);
        if (subscriber.isEmpty()) {
            reject(RejectCause.CONGESTION);
        } else if (!mobility.claim(subscriber.get(), imei, link)) {
            reject(RejectCause.ILLEGAL_MS);
        } else {
            accept(subscriber.get(), imei);
        }
    }

    private void accept(Subscriber subscriber, Imei imei) {
        await(State.AWAITING_TMSI_COMPLETE);
        link.send(new MobilityManagement.LocationUpdatingAccept(
                LocationArea.TEST, Optional.of(mobility.register().allocateTmsi(subscriber))));
        mobility.attached(subscriber, imei, link);
    }

    private void ask(MobileIdentity.Type type, State next) {
        await(next);
        link.send(new MobilityManagement.IdentityRequest(type));
    }

    private void await(State next) {
        timers.cancel(guard);
        state = next;
        guard = timers.start(ANSWER_NANOS, this::end);
    }

    private void reject(RejectCause cause) {
        log(cause.title());
        link.send(new MobilityManagement.LocationUpdatingReject(cause));
        end();
    }

    private void log(String reason) {
        LOG.log(Level.INFO, "{0}: registration refused, {1}{2}", link, reason, imsi == null ? "" : ", IMSI " + imsi);
    }

    /** The connection served the update alone; whatever waits for the mobile pages it afterwards. */
    private void end() {
        cancel();
        link.radio.release();
    }

    /** Forgets the update; the radio connection has gone, or a new update begins. */
    void cancel() {
        timers.cancel(guard);
        link.authenticity.cancel();
        link.registration = null;
    }
}
