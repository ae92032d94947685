package simgsm.station;

enum MobileRegistrationEvent {
    POWER_ON,
    POWER_OFF,
    CELL_FOUND,
    LINK_LOST,
    LOCATION_UPDATING_ACCEPTED,
    LOCATION_UPDATING_REJECTED,
    /** As before, for a reason that another try would only meet again. */
    LOCATION_UPDATING_FORBIDDEN,
    AUTHENTICATION_REJECTED,
    /** A service was refused because the network does not know us: it has forgotten what it had registered. */
    FORGOTTEN_BY_NETWORK,
    CHANNEL_RELEASED,
    T3210_EXPIRED,
    T3211_EXPIRED,
    T3220_EXPIRED
}
