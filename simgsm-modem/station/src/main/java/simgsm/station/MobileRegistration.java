package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import simgsm.air.Imsi;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;

/** Keeps the station known to the network: performs what {@link MobileRegistrationTable} says. */
final class MobileRegistration {
    /** Ciphering key sequence number that means "no key" (TS 24.008, 10.5.1.2). */
    private static final int NO_KEY = 7;

    /** Ours: the pause after the fifth refusal and all further ones, in first pauses. */
    private static final int LONGEST_PAUSE = 16;

    /** After these the card or the equipment counts as invalid here (TS 24.008, 4.4.4.7). Cause 3 is not among them: it also says that a number is in use, which passes. */
    private static final Set<RejectCause> FINAL =
            EnumSet.of(RejectCause.IMSI_UNKNOWN_IN_HLR, RejectCause.ILLEGAL_ME, RejectCause.PLMN_NOT_ALLOWED);

    private final StationParts parts;
    private MobileRegistrationState state = MobileRegistrationState.NO_CELL_AVAILABLE;
    private boolean cellFound;
    private int keySequence = NO_KEY;
    private int pause = 1;
    private Optional<Tmsi> tmsi = Optional.empty();
    private LocationArea area = LocationArea.TEST;
    private Optional<MobileIdentity> offeredIdentity = Optional.empty();
    private Optional<RejectCause> rejectCause = Optional.empty();
    private boolean cardRefused;
    /** What the user was told last; empty before the first word. */
    private Optional<String> told = Optional.empty();

    MobileRegistration(StationParts parts) {
        this.parts = parts;
    }

    MobileRegistrationState state() {
        return state;
    }

    boolean isRegistered() {
        return state == MobileRegistrationState.NORMAL_SERVICE;
    }

    /** Whether the network has said no; it may be asked again after a pause, and then say yes. */
    boolean isRefused() {
        return state == MobileRegistrationState.LIMITED_SERVICE
                || state == MobileRegistrationState.ATTEMPTING_TO_UPDATE && rejectCause.isPresent();
    }

    boolean isPowered() {
        return state != MobileRegistrationState.NULL && state != MobileRegistrationState.IMSI_DETACH_INITIATED;
    }

    /** Whether registration itself uses the radio connection now. */
    boolean needsRadio() {
        return state == MobileRegistrationState.LOCATION_UPDATING_INITIATED
                || state == MobileRegistrationState.IMSI_DETACH_INITIATED;
    }

    Optional<RejectCause> rejectCause() {
        return rejectCause;
    }

    /** Whether the network has refused because the card could not prove itself. */
    boolean isCardRefused() {
        return cardRefused;
    }

    private void notRefused() {
        rejectCause = Optional.empty();
        cardRefused = false;
    }

    /** How the station names itself on the air: by the temporary identity, if it has one. */
    MobileIdentity identity() {
        return tmsi.<MobileIdentity>map(t -> t).orElse(parts.identity().imsi());
    }

    boolean isMine(MobileIdentity identity) {
        return identity.equals(parts.identity().imsi())
                || tmsi.isPresent() && tmsi.get().equals(identity);
    }

    Optional<Tmsi> tmsi() {
        return tmsi;
    }

    int keySequence() {
        return keySequence;
    }

    void setKeySequence(int keySequence) {
        this.keySequence = keySequence;
    }

    void cellFound() {
        if (!cellFound) {
            cellFound = true;
            pause = 1;
            happens(MobileRegistrationEvent.CELL_FOUND);
        }
    }

    void linkLost() {
        cellFound = false;
        notRefused();
        happens(MobileRegistrationEvent.LINK_LOST);
    }

    void powerOn() {
        happens(MobileRegistrationEvent.POWER_ON);
    }

    void powerOff() {
        notRefused();
        happens(MobileRegistrationEvent.POWER_OFF);
    }

    void accepted(LocationUpdatingAccept accept) {
        if (state == MobileRegistrationState.LOCATION_UPDATING_INITIATED || isRegistered()) {
            area = accept.area();
            offeredIdentity = accept.newIdentity();
            notRefused();
            pause = 1;
        }
        happens(MobileRegistrationEvent.LOCATION_UPDATING_ACCEPTED);
    }

    void rejected(RejectCause cause) {
        if (state == MobileRegistrationState.LOCATION_UPDATING_INITIATED) {
            rejectCause = Optional.of(cause);
        }
        happens(
                FINAL.contains(cause)
                        ? MobileRegistrationEvent.LOCATION_UPDATING_FORBIDDEN
                        : MobileRegistrationEvent.LOCATION_UPDATING_REJECTED);
    }

    /** The network does not believe our card (TS 24.008, 4.3.2.5). */
    void authenticationRejected() {
        rejectCause = Optional.of(RejectCause.ILLEGAL_MS);
        cardRefused = true;
        happens(MobileRegistrationEvent.AUTHENTICATION_REJECTED);
    }

    void forgottenByNetwork() {
        happens(MobileRegistrationEvent.FORGOTTEN_BY_NETWORK);
    }

    void channelReleased() {
        happens(MobileRegistrationEvent.CHANNEL_RELEASED);
    }

    void t3210Expired() {
        happens(MobileRegistrationEvent.T3210_EXPIRED);
    }

    void t3211Expired() {
        happens(MobileRegistrationEvent.T3211_EXPIRED);
    }

    void t3220Expired() {
        happens(MobileRegistrationEvent.T3220_EXPIRED);
    }

    private void happens(MobileRegistrationEvent event) {
        var row = MobileRegistrationTable.ROWS.row(state, event);
        if (row.isEmpty()) {
            parts.log().refused(state, event);
            return;
        }
        parts.log().trace(Level.DEBUG, "{0} {1} -> {2}", state, event, row.get().next());
        state = row.get().next();
        row.get().actions().forEach(this::perform);
    }

    private void perform(MobileRegistrationAction action) {
        switch (action) {
            case LOOK_FOR_CELL -> lookForCell();
            case SEND_LOCATION_UPDATING_REQUEST -> sendLocationUpdatingRequest();
            case TAKE_NEW_IDENTITY -> takeNewIdentity();
            case FORGET_IDENTITY -> forgetIdentity();
            case SEND_IMSI_DETACH -> sendImsiDetach();
            case RELEASE_CHANNEL -> parts.radio().release();
            case PAUSE -> pause();
            case STOP_TIMERS -> stopTimers();
            case TELL_REGISTERED -> tellRegistered();
            case TELL_UNREGISTERED -> tellUnregistered();
        }
    }

    private void lookForCell() {
        parts.radio().release();
        if (cellFound) {
            happens(MobileRegistrationEvent.CELL_FOUND);
        }
    }

    /** The first message of a radio connection, so a connection that is still open ends before. */
    private void sendLocationUpdatingRequest() {
        parts.radio().release();
        parts.radio()
                .send(new LocationUpdatingRequest(LocationUpdatingType.IMSI_ATTACH, keySequence, area, identity()));
        parts.timers().start(StationTimer.T3210);
    }

    private void takeNewIdentity() {
        offeredIdentity.ifPresent(offered -> {
            if (offered instanceof Tmsi newTmsi) {
                tmsi = Optional.of(newTmsi);
                parts.radio().send(new TmsiReallocationComplete());
            } else if (offered instanceof Imsi) {
                tmsi = Optional.empty();
            }
        });
    }

    private void forgetIdentity() {
        tmsi = Optional.empty();
        keySequence = NO_KEY;
    }

    /** On a connection of its own: one that the network is about to release would not be listened to any more. */
    private void sendImsiDetach() {
        parts.radio().release();
        parts.radio().send(new ImsiDetachIndication(identity()));
        parts.timers().start(StationTimer.T3220);
    }

    private void pause() {
        parts.timers().start(StationTimer.T3211, pause * StationTimer.T3211.nanos());
        pause = Math.min(2 * pause, LONGEST_PAUSE);
    }

    private void stopTimers() {
        parts.timers().stop(StationTimer.T3210);
        parts.timers().stop(StationTimer.T3211);
        parts.timers().stop(StationTimer.T3220);
    }

    private void tellRegistered() {
        told = Optional.of("registered");
        parts.log().trace(Level.INFO, "registered");
        parts.notifications()
                .add(listener -> listener.registered(parts.identity().number()));
    }

    private void tellUnregistered() {
        Optional<RejectCause> cause = rejectCause;
        Optional<String> news = Optional.of("unregistered " + cause);
        if (!news.equals(told)) {
            told = news;
            parts.log()
                    .trace(
                            Level.INFO,
                            "unregistered {0}",
                            cause.map(RejectCause::title).orElse(""));
            parts.notifications().add(listener -> listener.unregistered(cause));
        }
    }
}
