package simgsm.station.mobility;

/** Mobility management states of a mobile, as far as one cell needs them (TS 24.008, 4.1.2.1). */
public enum MobileRegistrationState {
    /** Switched off. */
    NULL,
    /** No link to a centre, or to one that has not identified itself. */
    NO_CELL_AVAILABLE,
    LOCATION_UPDATING_INITIATED,
    /** Refused or not answered; the next attempt follows after a pause. */
    ATTEMPTING_TO_UPDATE,
    /** Refused for good: the next attempt follows only after power on or with another cell. */
    LIMITED_SERVICE,
    /** Registered. */
    NORMAL_SERVICE,
    IMSI_DETACH_INITIATED
}
