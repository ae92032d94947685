package simgsm.center.msc.link;

/** A transaction that the network begins, waiting for a radio connection. */
public interface PagedTransaction {
    /** The mobile is on a radio connection; called once per request. */
    void radioConnected();

    /** The mobile did not answer, or has detached. */
    void pagingFailed();
}
