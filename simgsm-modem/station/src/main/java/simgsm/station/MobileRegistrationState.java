package simgsm.station;

/** Mobility management states of a mobile, as far as one cell needs them (TS 24.008, 4.1.2.1). */
enum MobileRegistrationState {
    /** Switched off. */
    NULL,
    /** No link to a centre, or one that has not said who it is. */
    NO_CELL_AVAILABLE,
    LOCATION_UPDATING_INITIATED,
    /** Refused or unheard; tries again after a pause. */
    ATTEMPTING_TO_UPDATE,
    /** Refused for good: nothing is tried again before the mobile is switched on anew, or finds another cell. */
    LIMITED_SERVICE,
    /** Registered. */
    NORMAL_SERVICE,
    IMSI_DETACH_INITIATED
}
