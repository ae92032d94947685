package simgsm.phone.handset;

import simgsm.dtmf.DtmfKey;

/** How keys get to the far end: as sound, or as messages from which the network makes the sound. */
interface KeyWay {
    /** Appends a key of 100 ms. */
    void enqueue(DtmfKey key);

    /** A key goes down, to sound until {@link #release}; one that was down goes up. */
    void press(DtmfKey key);

    void release();

    /** Forgets what has not left. */
    void drop();

    /** The key that sounds now, or null. */
    DtmfKey sounding();

    /**
     * The next 20 ms.
     *
     * @param said what goes to the far end
     * @param heard what is heard at one's own ear
     */
    void read(short[] said, short[] heard);
}
