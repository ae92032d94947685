package simgsm.center.msc;

/** What can happen to a call leg. */
enum NetworkCallEvent {
    // From the mobile.
    SETUP_RECEIVED,
    CALL_CONFIRMED_RECEIVED,
    ALERTING_RECEIVED,
    CONNECT_RECEIVED,
    CONNECT_ACKNOWLEDGE_RECEIVED,
    DISCONNECT_RECEIVED,
    RELEASE_RECEIVED,
    RELEASE_COMPLETE_RECEIVED,
    /** STATUS that reports call state 0: the mobile no longer knows the call (TS 24.008, 8.4). */
    STATUS_NULL_RECEIVED,

    // From the call that the leg belongs to.
    PAGE,
    PROCEED,
    ALERT,
    ANSWER,
    CLEAR,

    // From the layers below.
    RADIO_CONNECTED,
    PAGING_FAILED,
    LINK_LOST,

    T301_EXPIRED,
    T303_EXPIRED,
    T305_EXPIRED,
    T306_EXPIRED,
    T308_EXPIRED,
    /** T308 again, after the repeated RELEASE. */
    T308_EXPIRED_AGAIN,
    T310_EXPIRED,
    T313_EXPIRED
}
