package simgsm.center.msc;

/** Something that the network wants from a mobile and that waits for a radio connection to it. */
interface PagedTransaction {
    /** There is a radio connection now; called once a request. */
    void radioConnected();

    /** The mobile did not answer, or has gone. */
    void pagingFailed();
}
