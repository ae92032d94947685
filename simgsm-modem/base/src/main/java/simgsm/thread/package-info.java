/** Threads of the programs' shells; the cores have none. */
package simgsm.thread;
